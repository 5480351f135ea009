#include "tlsph/operators/gradients.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

/// Reciprocal condition below which a moment matrix counts as singular.
constexpr double singular = 1e-10;

/// Whether the arms to the nodes within h span the space, none of its directions nearly missing.
template <int D>
bool spans(const VectorField<D>& X, Index p, double h) {
  constexpr double clear = 1e-2;
  const VectorField<D> point = X.row(p);
  Tensor<D> moment = Tensor<D>::Zero();
  for (const int q : find_neighbours<D>(point, X, h).column) {
    const Vector<D> arm = (X.row(q) - X.row(p)).transpose() / h;
    moment += arm * arm.transpose();
  }
  return std::abs(moment.determinant()) > std::pow(clear, D);
}

template <int D>
[[noreturn]] void too_few_neighbours(const Neighbours& near, const VectorField<D>& X, Index p,
                                     double h) {
  constexpr double margin = 1.05;              // within the rim, where the kernel is zero
  constexpr double ratio = 1.1, widest = 2.5;  // of the supports that are tried
  std::string cure = "a thicker body or a finer spacing";
  for (double times = ratio; times <= widest; times *= ratio)
    if (spans<D>(X, p, times * h / margin)) {
      cure = fmt::format("a support {:.2f} times as large", times);
      break;
    }
  const Vector<D> at = X.row(p).transpose();
  throw InputError(
      fmt::format("kernel.support: the {} neighbours of the particle at ({:.6g}) within "
                  "{:.6g} m do not determine a gradient; choose {}",
                  near.of(p).size(), fmt::join(at.data(), at.data() + D, ", "), h, cure));
}

/// ∇W at the nodes around p, with Shepard's constant correction (53), (57) in `mixed`:
/// (∇W − γ W)/Σ V W, γ = Σ V ∇W / Σ V W.
template <int D>
std::vector<Vector<D>> slopes(const Support<D>& support, const ScalarField& V, bool mixed) {
  std::vector<Vector<D>> slope(support.nodes.size());
  double sum = 0.0;
  Vector<D> gamma = Vector<D>::Zero();
  for (std::size_t k = 0; k < slope.size(); ++k) {
    slope[k] = support.slope(k);
    const double volume = V[support.nodes[k]];
    sum += volume * support.value[static_cast<Index>(k)];
    gamma += volume * slope[k];
  }
  if (!mixed) return slope;
  gamma /= sum;
  for (std::size_t k = 0; k < slope.size(); ++k)
    slope[k] = (slope[k] - gamma * support.value[static_cast<Index>(k)]) / sum;
  return slope;
}

template <int D>
using Row = std::vector<std::pair<int, Vector<D>>>;

/// Mean over the polygon of those nodes, counter-clockwise: ∮ f n dS along its straight edges, over
/// its area.
Row<2> mean_gradient(const VectorField<2>& X, std::span<const int> nodes, double area) {
  const std::size_t n = nodes.size();
  Row<2> row;
  for (std::size_t k = 0; k < n; ++k) {
    const auto next = X.row(nodes[(k + 1) % n]), last = X.row(nodes[(k + n - 1) % n]);
    const Vector<2> weight(0.5 * (next[1] - last[1]), -0.5 * (next[0] - last[0]));
    row.emplace_back(nodes[k], weight / area);
  }
  return row;
}

}  // namespace

template <int D>
SparseMatrix kernel_matrix(const AnyKernel& kernel, double h, const VectorField<D>& X,
                           const ScalarField& V) {
  const Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> values;
  values.reserve(near.column.size());
  for (Index p = 0; p < X.rows(); ++p) {
    const Support<D> support(kernel, h, X.row(p).transpose(), near.of(p), X);
    for (Index k = 0; k < support.size(); ++k)
      values.push_back(V[support.nodes[static_cast<std::size_t>(k)]] * support.value[k]);
  }
  return matrix_of(near, X.rows(), [&](Index k) { return values[static_cast<std::size_t>(k)]; });
}

template <int D>
VectorOperator<D> plain_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                 const ScalarField& V) {
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights;
  weights.reserve(near.column.size() * D);
  for (Index p = 0; p < X.rows(); ++p) {
    const Support<D> support(kernel, h, X.row(p).transpose(), near.of(p), X);
    for (std::size_t k = 0; k < support.nodes.size(); ++k) {
      const Vector<D> weight = V[support.nodes[k]] * support.slope(k);
      weights.insert(weights.end(), weight.data(), weight.data() + D);
    }
  }
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> collocated_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                      const ScalarField& V, Correction correction) {
  if (correction == Correction::least_squares) return point_gradient<D>(kernel, h, X, X);
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights;
  weights.reserve(near.column.size() * D);
  for (Index p = 0; p < X.rows(); ++p) {
    const Support<D> support(kernel, h, X.row(p).transpose(), near.of(p), X);
    std::vector<Vector<D>> row = slopes<D>(support, V, correction == Correction::mixed);
    // L = (Σ V ∇W ⊗ (X_q − X_p))⁻¹, (45) and (58).
    Tensor<D> L = Tensor<D>::Identity();
    if (correction != Correction::none) {
      const Tensor<D> moment = support.moment(row, V);
      if (!is_regular<D>(moment, 1.0, singular)) too_few_neighbours<D>(near, X, p, h);
      L = moment.inverse();
    }
    support.weigh(row, L, V);
    support.close(row, p);
    for (const Vector<D>& weight : row)
      weights.insert(weights.end(), weight.data(), weight.data() + D);
  }
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> cell_gradient(const Particles<D>& particles, const MaterialPoints<D>& points) {
  OperatorRows rows;
  rows.reserve(static_cast<std::size_t>(points.size()), std::size_t{1} << D, D);
  Index s = 0;
  for (const Cell<D>& cell : particles.cells) {
    const double volume = points.V[s++];
    if constexpr (D == 1)
      rows.add_row(Row<1>{{cell[0], Vector<1>(-1.0 / volume)}, {cell[1], Vector<1>(1.0 / volume)}});
    else
      rows.add_row(mean_gradient(particles.X, cell, volume));
  }
  if constexpr (D == 2)
    for (const auto& [a, b, left, right] : edges_of(particles.triangles)) {
      const auto corners = right < 0 ? std::vector{a, b, left} : std::vector{a, right, b, left};
      rows.add_row(mean_gradient(particles.X, corners, 3.0 * points.V[s++]));
    }
  return VectorOperator<D>(std::move(rows), particles.size());
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template SparseMatrix kernel_matrix<D>(const AnyKernel&, double, const VectorField<D>&,       \
                                         const ScalarField&);                                   \
  template VectorOperator<D> plain_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const ScalarField&);                             \
  template VectorOperator<D> collocated_gradient<D>(                                            \
      const AnyKernel&, double, const VectorField<D>&, const ScalarField&, Correction);         \
  template VectorOperator<D> cell_gradient<D>(const Particles<D>&, const MaterialPoints<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph

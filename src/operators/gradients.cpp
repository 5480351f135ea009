#include "tlsph/operators/gradients.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "moving_fit.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Reciprocal condition below which a moment matrix counts as singular, and the one that a row
/// whose radius is chosen here should have.
constexpr double singular = 1e-10, well_conditioned = 1e-7;
/// A row that its nodes do not determine takes those of a radius larger by this ratio, and again,
/// up to so many times the support.
constexpr double ratio = 1.1, widest = 2.5;

/// `X` as words.
template <int D>
std::string words_of(const Vector<D>& X) {
  std::string words;
  for (int a = 0; a < D; ++a) words += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", X[a]);
  return words;
}

template <int D>
VectorField<D> only(const VectorField<D>& X, Index row) {
  return X.row(row);
}

/// Whether the arms to the nodes within h span the space, none of its directions nearly missing.
template <int D>
bool spans(const VectorField<D>& X, Index p, double h) {
  constexpr double clear = 1e-2;
  Tensor<D> moment = Tensor<D>::Zero();
  for (const int q : find_neighbours<D>(only<D>(X, p), X, h).column) {
    const Vector<D> arm = (X.row(q) - X.row(p)).transpose() / h;
    moment += arm * arm.transpose();
  }
  return std::abs(moment.determinant()) > std::pow(clear, D);
}

template <int D>
[[noreturn]] void too_few_neighbours(const Neighbours& near, const VectorField<D>& X, Index p,
                                     double h) {
  constexpr double margin = 1.05;  // within the rim, where the kernel is zero
  std::string cure = "a thicker body or a finer spacing";
  for (double times = ratio; times <= widest; times *= ratio)
    if (spans<D>(X, p, times * h / margin)) {
      cure = fmt::format("a support {:.2f} times as large", times);
      break;
    }
  throw InputError(
      fmt::format("kernel.support: the {} neighbours of the particle at ({}) within "
                  "{:.6g} m do not determine a gradient; choose {}",
                  near.of(p).size(), words_of<D>(X.row(p).transpose()), h, cure));
}

/// ∇_p W(X_p − X_q); zero for the particle itself.
template <int D, class Family>
Vector<D> kernel_gradient(const Family& family, const Vector<D>& difference, double h) {
  const double r = difference.norm();
  if (r == 0.0) return Vector<D>::Zero();
  return kernel_first<D>(family, r, h) / r * difference;
}

/// Calls `entry(k, q, X_p − X_q)` for the entries of row p.
template <int D, class Entry>
void for_row(const Neighbours& near, const VectorField<D>& points, const VectorField<D>& X, Index p,
             const Entry& entry) {
  for (Index k = near.start[static_cast<std::size_t>(p)];
       k < near.start[static_cast<std::size_t>(p) + 1]; ++k) {
    const Index q = near.column[static_cast<std::size_t>(k)];
    const Vector<D> difference = (points.row(p) - X.row(q)).transpose();
    entry(k, q, difference);
  }
}

template <int D>
void store(std::vector<double>& weights, Index k, const Vector<D>& value) {
  for (int a = 0; a < D; ++a) weights[static_cast<std::size_t>(k * D + a)] = value[a];
}

/// The nodes around a point and D weights for each.
struct FittedRow {
  std::vector<int> nodes;
  std::vector<double> weights;
};

/// The fits at the points `open`, each over no more nodes than a well-conditioned one needs. All
/// points that are left share the search of a radius.
template <int D, class Family>
std::map<Index, FittedRow> wider_rows(const MovingFit<D, Family>& fit, const VectorField<D>& points,
                                      const VectorField<D>& X, std::vector<Index> open, double h) {
  std::map<Index, FittedRow> rows;
  for (const double least : {well_conditioned, singular})
    for (double times = ratio; times <= widest && !open.empty(); times *= ratio) {
      const Neighbours near = find_neighbours<D>(points(open, Eigen::all), X, times * h);
      std::vector<Index> left;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const std::span<const int> nodes = near.of(static_cast<Index>(k));
        FittedRow row{{nodes.begin(), nodes.end()}, std::vector<double>(nodes.size() * D)};
        if (fit.weights(open[k], nodes, times * h, least, row.weights.data()))
          rows.emplace(open[k], std::move(row));
        else
          left.push_back(open[k]);
      }
      open = std::move(left);
    }
  if (!open.empty())
    throw InputError(
        fmt::format("kernel.order: the nodes around ({}) do not determine a polynomial "
                    "of degree {}; choose a thicker body, a finer spacing or a lower "
                    "degree",
                    words_of<D>(points.row(open.front()).transpose()), fit.degree()));
  return rows;
}

/// The operator of the rows of `near`, those of `wider` in their places.
template <int D>
VectorOperator<D> merged(Index cols, const Neighbours& near, const std::vector<double>& weights,
                         const std::map<Index, FittedRow>& wider) {
  Neighbours pattern;
  std::vector<double> values;
  pattern.start.push_back(0);
  const auto append = [&](std::span<const int> nodes, std::span<const double> of_nodes) {
    pattern.column.insert(pattern.column.end(), nodes.begin(), nodes.end());
    values.insert(values.end(), of_nodes.begin(), of_nodes.end());
    pattern.start.push_back(pattern.size());
  };
  for (Index s = 0; s < near.rows(); ++s) {
    const auto found = wider.find(s);
    const auto first = static_cast<std::size_t>(near.start[static_cast<std::size_t>(s)] * D);
    if (found == wider.end())
      append(near.of(s), std::span(weights).subspan(first, near.of(s).size() * D));
    else
      append(found->second.nodes, found->second.weights);
  }
  return VectorOperator<D>(near.rows(), cols, std::move(pattern), std::move(values));
}

}  // namespace

template <int D>
SparseMatrix kernel_matrix(const AnyKernel& kernel, double h, const VectorField<D>& X,
                           const ScalarField& V) {
  const Neighbours near = find_neighbours<D>(X, X, h);
  SparseMatrix W(X.rows(), X.rows());
  W.resizeNonZeros(near.size());
  for (Index p = 0; p <= X.rows(); ++p)
    W.outerIndexPtr()[p] = static_cast<int>(near.start[static_cast<std::size_t>(p)]);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p)
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            W.innerIndexPtr()[k] = static_cast<int>(q);
            W.valuePtr()[k] = V[q] * kernel_value<D>(family, difference.norm(), h);
          });
      },
      kernel);
  return W;
}

template <int D>
VectorOperator<D> plain_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                 const ScalarField& V) {
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights(near.column.size() * D);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p)
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            store<D>(weights, k, V[q] * kernel_gradient<D>(family, difference, h));
          });
      },
      kernel);
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> collocated_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                      const ScalarField& V, Correction correction) {
  if (correction == Correction::least_squares) return point_gradient<D>(kernel, h, X, X);
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights(near.column.size() * D);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p) {
          // Shepard's constant correction (53), (57): γ = Σ V ∇W / Σ V W; zero for the others.
          double sum = 1.0;
          Vector<D> gamma = Vector<D>::Zero();
          if (correction == Correction::mixed) {
            sum = 0.0;
            for_row<D>(near, X, X, p, [&](Index, Index q, const Vector<D>& difference) {
              sum += V[q] * kernel_value<D>(family, difference.norm(), h);
              gamma += V[q] * kernel_gradient<D>(family, difference, h);
            });
            gamma /= sum;
          }
          const auto gradient = [&](const Vector<D>& difference) -> Vector<D> {
            Vector<D> plain = kernel_gradient<D>(family, difference, h);
            if (correction != Correction::mixed) return plain;
            return (plain - gamma * kernel_value<D>(family, difference.norm(), h)) / sum;
          };
          // L = (Σ V ∇W ⊗ (X_q − X_p))⁻¹, (45) and (58).
          Tensor<D> L = Tensor<D>::Identity();
          if (correction != Correction::none) {
            Tensor<D> moment = Tensor<D>::Zero();
            for_row<D>(near, X, X, p, [&](Index, Index q, const Vector<D>& difference) {
              moment -= V[q] * gradient(difference) * difference.transpose();
            });
            if (!is_regular<D>(moment, 1.0, singular)) too_few_neighbours<D>(near, X, p, h);
            L = moment.inverse();
          }
          Vector<D> others = Vector<D>::Zero();
          Index self = -1;
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            if (q == p) {
              self = k;
              return;
            }
            const Vector<D> weight = V[q] * L * gradient(difference);
            others += weight;
            store<D>(weights, k, weight);
          });
          store<D>(weights, self, -others);
        }
      },
      kernel);
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> point_gradient(const AnyKernel& kernel, double h, const VectorField<D>& points,
                                 const VectorField<D>& X, int order) {
  return std::visit(
      [&](const auto& family) {
        const MovingFit<D, std::decay_t<decltype(family)>> fit(family, points, X, order);
        Neighbours near = find_neighbours<D>(points, X, h);
        std::vector<double> weights(near.column.size() * D);
        std::vector<Index> open;
        for (Index s = 0; s < points.rows(); ++s) {
          const Index first = near.start[static_cast<std::size_t>(s)];
          if (!fit.weights(s, near.of(s), h, singular, weights.data() + first * D))
            open.push_back(s);
        }
        if (!open.empty())
          return merged<D>(X.rows(), near, weights, wider_rows<D>(fit, points, X, open, h));
        return VectorOperator<D>(points.rows(), X.rows(), std::move(near), std::move(weights));
      },
      kernel);
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template SparseMatrix kernel_matrix<D>(const AnyKernel&, double, const VectorField<D>&,       \
                                         const ScalarField&);                                   \
  template VectorOperator<D> plain_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const ScalarField&);                             \
  template VectorOperator<D> collocated_gradient<D>(                                            \
      const AnyKernel&, double, const VectorField<D>&, const ScalarField&, Correction);         \
  template VectorOperator<D> point_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const VectorField<D>&, int);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

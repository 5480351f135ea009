#include "tlsph/dynamics/stabiliser_forces.hpp"

#include <algorithm>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

/// Σ_s A_sq κ_s Σ_r A_sr (u_r − u_q) over the cells s around node q. Each cell is summed anew for
/// each of its nodes, so that rows need no field between them.
template <int D>
Vector<D> hourglass_row(const Discretisation<D>& body, Index q, const VectorField<D>& u) {
  const Neighbours& nodes = body.gradient.pattern();
  const Neighbours& cells = body.divergence.pattern();
  const double* x = u.data();
  double sum[D] = {};
  for (const int cell : cells.of(q)) {
    const auto s = static_cast<std::size_t>(cell);
    double own = 0.0;
    double amplitude[D] = {};
    for (Index k = nodes.start[s]; k < nodes.start[s + 1]; ++k) {
      const Index r = nodes.column[static_cast<std::size_t>(k)];
      const double weight = body.hourglass.weights[static_cast<std::size_t>(k)];
      if (r == q) own = weight;
      for (int i = 0; i < D; ++i) amplitude[i] += weight * (x[r * D + i] - x[q * D + i]);
    }
    const double factor = own * body.hourglass.modulus[cell];
    for (int i = 0; i < D; ++i) sum[i] += factor * amplitude[i];
  }
  return Eigen::Map<const Vector<D>>(sum);
}

template <int D>
double hourglass_energy(const Discretisation<D>& body, const VectorField<D>& u) {
  const Neighbours& nodes = body.gradient.pattern();
  double energy = 0.0;
  for (Index s = 0; s < body.hourglass.modulus.size(); ++s) {
    const Index begin = nodes.start[static_cast<std::size_t>(s)];
    const Index end = nodes.start[static_cast<std::size_t>(s) + 1];
    Vector<D> amplitude = Vector<D>::Zero();
    for (Index k = begin + 1; k < end; ++k)
      amplitude += body.hourglass.weights[static_cast<std::size_t>(k)] *
                   (u.row(nodes.column[static_cast<std::size_t>(k)]) -
                    u.row(nodes.column[static_cast<std::size_t>(begin)]))
                       .transpose();
    energy += 0.5 * body.hourglass.modulus[s] * amplitude.squaredNorm();
  }
  return energy;
}

}  // namespace

template <int D>
void subtract_stabiliser(const Discretisation<D>& body, const VectorField<D>& u,
                         VectorField<D>& f) {
  if (!body.hourglass.empty())
    for_rows(body.nodes(), [&](Index q) { f.row(q) -= hourglass_row<D>(body, q, u).transpose(); });
  if (body.stiffness.nonZeros() > 0) subtract_differences<D>(body.stiffness, u, f);
}

template <int D>
Vector<D> stabiliser_row(const Discretisation<D>& body, Index q, const VectorField<D>& u) {
  Vector<D> sum = Vector<D>::Zero();
  if (!body.hourglass.empty()) sum += hourglass_row<D>(body, q, u);
  if (body.stiffness.nonZeros() > 0) sum += differences_row<D>(body.stiffness, q, u);
  return sum;
}

template <int D>
double stabiliser_energy(const Discretisation<D>& body, const VectorField<D>& u) {
  double energy = body.hourglass.empty() ? 0.0 : hourglass_energy<D>(body, u);
  for (Index p = 0; p < body.stiffness.outerSize(); ++p)
    for (SparseMatrix::InnerIterator it(body.stiffness, p); it; ++it)
      energy -= 0.25 * it.value() * (u.row(p) - u.row(it.col())).squaredNorm();
  return energy;
}

template <int D>
SparseMatrix stabiliser_matrix(const Discretisation<D>& body) {
  if (body.hourglass.empty()) return body.stiffness;
  SparseMatrix rows = body.gradient.matrix(0);  // for its pattern
  std::ranges::copy(body.hourglass.weights, rows.valuePtr());
  const SparseMatrix S = normal_matrix(rows, body.hourglass.modulus);
  return body.stiffness.nonZeros() > 0 ? SparseMatrix(S + body.stiffness) : S;
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template void subtract_stabiliser<D>(const Discretisation<D>&, const VectorField<D>&,         \
                                       VectorField<D>&);                                        \
  template Vector<D> stabiliser_row<D>(const Discretisation<D>&, Index, const VectorField<D>&); \
  template double stabiliser_energy<D>(const Discretisation<D>&, const VectorField<D>&);        \
  template SparseMatrix stabiliser_matrix<D>(const Discretisation<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

#include "tlsph/dynamics/stabiliser_forces.hpp"

#include <algorithm>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

/// Σ_s A_sq κ_s Σ_r A_sr (u_r − u_q) over the cells s around node q. Each cell is summed anew for
/// each of its nodes, so that rows need no field between them.
template <int D>
Vector<D> hourglass_row(const Discretisation<D>& disc, Index q, const VectorField<D>& u) {
  const Neighbours& nodes = disc.gradient.pattern();
  const Neighbours& cells = disc.divergence.pattern();
  const double* x = u.data();
  double sum[D] = {};
  for (const int cell : cells.of(q)) {
    const auto s = static_cast<std::size_t>(cell);
    double own = 0.0;
    double amplitude[D] = {};
    for (Index k = nodes.start[s]; k < nodes.start[s + 1]; ++k) {
      const Index r = nodes.column[static_cast<std::size_t>(k)];
      const double weight = disc.hourglass.weights[static_cast<std::size_t>(k)];
      if (r == q) own = weight;
      for (int i = 0; i < D; ++i) amplitude[i] += weight * (x[r * D + i] - x[q * D + i]);
    }
    const double factor = own * disc.hourglass.modulus[cell];
    for (int i = 0; i < D; ++i) sum[i] += factor * amplitude[i];
  }
  return Eigen::Map<const Vector<D>>(sum);
}

template <int D>
double hourglass_energy(const Discretisation<D>& disc, const VectorField<D>& u) {
  const Neighbours& nodes = disc.gradient.pattern();
  double energy = 0.0;
  for (Index s = 0; s < disc.hourglass.modulus.size(); ++s) {
    const Index begin = nodes.start[static_cast<std::size_t>(s)];
    const Index end = nodes.start[static_cast<std::size_t>(s) + 1];
    Vector<D> amplitude = Vector<D>::Zero();
    for (Index k = begin + 1; k < end; ++k)
      amplitude += disc.hourglass.weights[static_cast<std::size_t>(k)] *
                   (u.row(nodes.column[static_cast<std::size_t>(k)]) -
                    u.row(nodes.column[static_cast<std::size_t>(begin)]))
                       .transpose();
    energy += 0.5 * disc.hourglass.modulus[s] * amplitude.squaredNorm();
  }
  return energy;
}

}  // namespace

template <int D>
void subtract_stabiliser(const Discretisation<D>& disc, const VectorField<D>& u,
                         VectorField<D>& f) {
  if (!disc.hourglass.empty())
    for_rows(disc.nodes(), [&](Index q) { f.row(q) -= hourglass_row<D>(disc, q, u).transpose(); });
  if (disc.stiffness.nonZeros() > 0) subtract_differences<D>(disc.stiffness, u, f);
}

template <int D>
Vector<D> stabiliser_row(const Discretisation<D>& disc, Index q, const VectorField<D>& u) {
  Vector<D> sum = Vector<D>::Zero();
  if (!disc.hourglass.empty()) sum += hourglass_row<D>(disc, q, u);
  if (disc.stiffness.nonZeros() > 0) sum += differences_row<D>(disc.stiffness, q, u);
  return sum;
}

template <int D>
double stabiliser_energy(const Discretisation<D>& disc, const VectorField<D>& u) {
  double energy = disc.hourglass.empty() ? 0.0 : hourglass_energy<D>(disc, u);
  for (Index p = 0; p < disc.stiffness.outerSize(); ++p)
    for (SparseMatrix::InnerIterator it(disc.stiffness, p); it; ++it)
      energy -= 0.25 * it.value() * (u.row(p) - u.row(it.col())).squaredNorm();
  return energy;
}

template <int D>
SparseMatrix stabiliser_matrix(const Discretisation<D>& disc) {
  if (disc.hourglass.empty()) return disc.stiffness;
  SparseMatrix rows = disc.gradient.matrix(0);  // for its pattern
  std::ranges::copy(disc.hourglass.weights, rows.valuePtr());
  const SparseMatrix S = normal_matrix(rows, disc.hourglass.modulus);
  return disc.stiffness.nonZeros() > 0 ? SparseMatrix(S + disc.stiffness) : S;
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

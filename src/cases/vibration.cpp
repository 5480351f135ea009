#include "vibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph {

template <int D>
State<D> state_at_rest(const Discretisation<D>& disc) {
  const VectorField<D> zero = VectorField<D>::Zero(disc.nodes(), D);
  return make_state<D>(disc, zero, zero);
}

template <int D>
SparseMatrix dynamical_matrix(const Discretisation<D>& disc) {
  const State<D> rest = state_at_rest<D>(disc);
  return LinearisedForces<D>(disc, rest).dynamical_matrix();
}

template <int D>
std::vector<double> squared_frequencies(const Discretisation<D>& disc) {
  std::vector<double> result;
  for (const auto& value : eigenvalues(dynamical_matrix<D>(disc))) result.push_back(value.real());
  std::ranges::sort(result);
  return result;
}

template <int D>
SparseMatrix torus_matrix(const Discretisation<D>& disc, int nodes) {
  State<D> state = state_at_rest<D>(disc);
  const LatticeFrame<D>& frame = *disc.particles.frame;
  std::array<int, D> middle;
  LatticeFrame<D> torus = frame;
  for (std::size_t a = 0; a < D; ++a) middle[a] = frame.counts[a] / 2;
  torus.counts.fill(nodes);
  const int size = static_cast<int>(std::pow(nodes, D));
  const int centre = frame.index(middle);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < D; ++i) {
    state.u(centre, i) = 1.0;
    evaluate<D>(disc, state);
    state.u(centre, i) = 0.0;
    for (int q = 0; q < disc.nodes(); ++q)
      for (int j = 0; j < D; ++j) {
        if (state.f(q, j) == 0.0) continue;
        const double value = -state.f(q, j) * disc.inverse_mass(centre, 0);
        for (int column = 0; column < size; ++column) {
          auto at = torus.coordinates(column);
          const auto there = frame.coordinates(q);
          for (std::size_t a = 0; a < D; ++a)
            at[a] = ((at[a] + there[a] - middle[a]) % nodes + nodes) % nodes;
          entries.emplace_back(torus.index(at) * D + j, column * D + i, value);
        }
      }
  }
  SparseMatrix result(size * D, size * D);
  result.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix transposed = result.transpose();
  return 0.5 * (result + transposed);
}

double squared_frequency(const Discretisation<1>& bar, Index centre, double k) {
  VectorField<1> wave(bar.nodes(), 1);
  for (Index q = 0; q < bar.nodes(); ++q)
    wave(q, 0) = std::cos(k * (bar.particles.X(q, 0) - bar.particles.X(centre, 0)));
  State<1> state = make_state<1>(bar, wave, VectorField<1>::Zero(bar.nodes(), 1));
  state.u = wave;  // held ends too: far from the centre they do not matter
  evaluate<1>(bar, state);
  return -bar.inverse_mass(centre, 0) * state.f(centre, 0);
}

template State<1> state_at_rest<1>(const Discretisation<1>&);
template State<2> state_at_rest<2>(const Discretisation<2>&);
template SparseMatrix dynamical_matrix<1>(const Discretisation<1>&);
template SparseMatrix dynamical_matrix<2>(const Discretisation<2>&);
template SparseMatrix torus_matrix<1>(const Discretisation<1>&, int);
template SparseMatrix torus_matrix<2>(const Discretisation<2>&, int);
template std::vector<double> squared_frequencies<1>(const Discretisation<1>&);
template std::vector<double> squared_frequencies<2>(const Discretisation<2>&);

}  // namespace tlsph

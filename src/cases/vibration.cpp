#include "vibration.hpp"

#include <algorithm>
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
template std::vector<double> squared_frequencies<1>(const Discretisation<1>&);
template std::vector<double> squared_frequencies<2>(const Discretisation<2>&);

}  // namespace tlsph

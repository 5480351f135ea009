#pragma once
/// \file
/// The vibrations of a linear body: its whole spectrum, and what one particle makes of a wave.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph {

/// The body undeformed and at rest, its forces not yet evaluated.
template <int D>
[[nodiscard]] State<D> state_at_rest(const Discretisation<D>& body) {
  const VectorField<D> zero = VectorField<D>::Zero(body.nodes(), D);
  return make_state<D>(body, zero, zero);
}

/// M^-½ K M^-½ over the degrees of freedom that are free [1/s²], K = −∂f/∂u column by column from
/// the forces of the run itself, stabiliser included. Linear laws only; N² time.
template <int D>
[[nodiscard]] SparseMatrix dynamical_matrix(const Discretisation<D>& body) {
  const State<D> rest = state_at_rest<D>(body);
  return LinearisedForces<D>(body, rest).dynamical_matrix();
}

/// All ω² of it, ascending [1/s²]; real parts where the forces come from no energy.
template <int D>
[[nodiscard]] std::vector<double> squared_frequencies(const Discretisation<D>& body) {
  std::vector<double> result;
  for (const auto& value : eigenvalues(dynamical_matrix<D>(body))) result.push_back(value.real());
  std::ranges::sort(result);
  return result;
}

/// ω² [1/s²] that node `centre` of a bar sees of the wave cos k(X − X_centre), k [1/m]: −a at the
/// crest of height one.
[[nodiscard]] inline double squared_frequency(const Discretisation<1>& bar, Index centre,
                                              double k) {
  VectorField<1> wave(bar.nodes(), 1);
  for (Index q = 0; q < bar.nodes(); ++q)
    wave(q, 0) = std::cos(k * (bar.particles.X(q, 0) - bar.particles.X(centre, 0)));
  State<1> state = make_state<1>(bar, wave, VectorField<1>::Zero(bar.nodes(), 1));
  state.u = wave;  // held ends too: far from the centre they do not matter
  evaluate<1>(bar, state);
  return -bar.inverse_mass(centre, 0) * state.f(centre, 0);
}

}  // namespace tlsph

#pragma once
/// \file
/// The vibrations of a linear body: its whole spectrum, and what one particle makes of a wave.

#include <vector>

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// The body undeformed and at rest, its forces not yet evaluated.
template <int D>
[[nodiscard]] State<D> state_at_rest(const Discretisation<D>& discretisation);

/// M^-½ K M^-½ over the degrees of freedom that are free [1/s²], K = −∂f/∂u column by column from
/// the forces of the run itself, stabiliser included. Linear laws only; N² time.
template <int D>
[[nodiscard]] SparseMatrix dynamical_matrix(const Discretisation<D>& discretisation);

/// All ω² of it, ascending [1/s²]; real parts where the forces come from no energy.
template <int D>
[[nodiscard]] std::vector<double> squared_frequencies(const Discretisation<D>& discretisation);

/// ω² [1/s²] that node `centre` of a bar sees of the wave cos k(X − X_centre), k [1/m]: −a at the
/// crest of height one.
[[nodiscard]] double squared_frequency(const Discretisation<1>& bar, Index centre, double k);

}  // namespace tlsph

#pragma once
/// \file
/// Vibrations that cost no energy though they are no rigid motion, and a stabiliser against them.

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// Adds ½ κ E Σ V/Δ² ½(e_pq² + e_qp²) over nearest neighbours to the energy of a bar, κ =
/// `coefficient`, with the one-sided errors e_pq = u_q − u_p − (G u)_p (X_q − X_p) of the bar's own
/// gradient. With its three-point gradient and κ = 4/3 the waves travel at
/// ω² = (c/Δ)² [sin²θ + (16/3) sin⁴(θ/2)], θ = kΔ.
void add_one_sided_stabiliser(Discretisation<1>& bar, double coefficient);

/// Bars and sheets with and without stabiliser, of the case `dispersion`: on a torus, where modes
/// without energy are exactly so, and as free bodies. Leaves the lowest frequencies of the free
/// sheets in `modes.csv`.
void count_zero_energy_modes(CaseRun& run);

}  // namespace tlsph

#pragma once
/// \file
/// The stabiliser that makes a bar fourth order.

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

/// Adds ½ κ E Σ V/Δ² ½(e_pq² + e_qp²) over nearest neighbours to the energy of a bar, κ =
/// `coefficient`, with the one-sided errors e_pq = u_q − u_p − (G u)_p (X_q − X_p) of the bar's own
/// gradient. With its three-point gradient and κ = 4/3 the waves travel at
/// ω² = (c/Δ)² [sin²θ + (16/3) sin⁴(θ/2)], θ = kΔ.
void add_one_sided_stabiliser(Discretisation<1>& bar, double coefficient);

}  // namespace tlsph

#pragma once
/// \file
/// The largest stable time step, from the spectrum of the run's own operators at a given state.

#include <optional>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

struct CriticalStep {
  double dt = 0.0;      ///< [s]
  double scaled = 0.0;  ///< c_p Δt/Δ
  /// Largest Re(s) of a free motion e^{st} [1/s]; only where D is not the adjoint of G.
  std::optional<double> growth;
};

/// Adjoint formulations: Lanczos on M^-½ K M^-½ gives the largest ω², and with a viscous matrix,
/// taken at the lagged half-step velocity, Δt solves λ_max(Δt² K + 2Δt C) = 4 relative to M, which
/// is where the first mode reaches z = −1. Others: Arnoldi on M⁻¹K, 2/√|λ|max, and the growth of
/// its non-real or negative eigenvalues. Evaluated at the displacement gradients `state.H`.
/// NumericalError if there is no stiffness to limit the step.
template <int D>
[[nodiscard]] CriticalStep critical_step(const Discretisation<D>& discretisation,
                                         const State<D>& state);
/// The same, nothing if there is no stiffness, as where a deformed material has lost it.
/// `tolerance` is the relative residual of ω²_max at which Lanczos stops; what is left of it counts
/// against Δt. A sweep of the same discretisation lends its operators.
template <int D>
[[nodiscard]] std::optional<CriticalStep> critical_step_if_any(
    const Discretisation<D>& discretisation, const State<D>& state, double tolerance = 1e-3,
    const Sweep<D>* sweep = nullptr);

/// γ = λ_max(M⁻¹ Gᵀ V G) [1/(Pa s²)]: the same operators with the unit tangent, to 5 %; the
/// largest modulus where D is not the adjoint of G.
template <int D>
[[nodiscard]] double unit_stiffness(const Discretisation<D>& discretisation, const Sweep<D>* sweep);

}  // namespace tlsph

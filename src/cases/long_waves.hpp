#pragma once
/// \file
/// How far a long wave in the lattice of particles lags behind one in the bar.

#include "tlsph/curves/curve.hpp"
#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

/// The a of ω = c k (1 − a (kΔ)² + O((kΔ)⁴)), a free wave of wave number k in the middle of a
/// uniform, linear elastic bar of particles, operators and time step `dt` together: the run's own
/// force on u = cos(kX) gives ω² of the operators, the central difference adds −(c dt/Δ)²/24.
/// Positive: short waves are late.
[[nodiscard]] double long_wave_lag(const Discretisation<1>& bar, double dt);

/// Where the front of a stress step stands: with such a dispersion a step arrives as ∫Ai, whose
/// value at the place of the exact front is 1/3, and whose largest, at the first zero of Ai, is
/// 1.2743…, at any resolution.
inline constexpr double front_level = 1.0 / 3.0;
inline constexpr double front_overshoot = 1.274352;

/// Relative L2 error in time that the dispersion a leaves in the stress after the path `x` [m],
/// a Δ² x ‖p'''‖/‖p‖/c³, for the erf pulse p of rise r and duration T ≫ r in a bar of speed c.
[[nodiscard]] double pulse_dispersion_error(double a, double spacing, double x,
                                            const PulseCurve& pulse, double speed);

}  // namespace tlsph

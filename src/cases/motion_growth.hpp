#pragma once
/// \file
/// How fast the motions of a linear body grow that its spectrum (vibration.hpp) does not hold.

#include <complex>
#include <vector>

namespace tlsph {

/// Largest Re(s) [1/s] of the free motions e^{st}, s² = −ω²: zero where all ω² are real and
/// positive, up to the square root of round-off.
[[nodiscard]] double growth_rate(const std::vector<std::complex<double>>& squared_frequencies);

/// ln |z| of the fastest motion zⁿ under the central difference of step `dt` [s], where
/// z − 2 + 1/z = −ω² dt².
[[nodiscard]] double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies,
                                     double dt);

}  // namespace tlsph

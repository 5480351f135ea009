#pragma once
/// \file
/// How fast motions grow: by the spectrum of the linear body, and as a run showed it.

#include <complex>
#include <span>
#include <vector>

namespace tlsph {

/// Largest Re(s) [1/s] of the free motions e^{st}, s² = −ω²: zero where all ω² are real and
/// positive, up to the square root of round-off.
[[nodiscard]] double growth_rate(const std::vector<std::complex<double>>& squared_frequencies);

/// ln |z| of the fastest motion zⁿ under the central difference of step `dt` [s], where
/// z − 2 + 1/z = −ω² dt².
[[nodiscard]] double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies,
                                     double dt);

/// Rate of exponential growth [1/s]: slope of ln(values) by least squares over the samples from the
/// first that reaches `low` to the last before `high`. Not a number where the values do not grow
/// that far.
[[nodiscard]] double growth_rate(std::span<const double> time, std::span<const double> values,
                                 double low, double high);

}  // namespace tlsph

#pragma once
/// \file
/// The motions of a bar of particles, all of them, and how fast each grows.

#include <complex>
#include <vector>

#include "tlsph/dynamics/discretisation.hpp"

namespace tlsph {

/// Eigenvalues ω² [1/s²] of M⁻¹K over the free nodes of a linear elastic bar, largest modulus
/// first, from the forces of the run's own operators on unit displacements. N² memory.
[[nodiscard]] std::vector<std::complex<double>> squared_frequencies(const Discretisation<1>& bar);

/// Largest Re(s) [1/s] of the free motions e^{st}, s² = −ω²: zero where all ω² are real and
/// positive, up to the square root of round-off.
[[nodiscard]] double growth_rate(const std::vector<std::complex<double>>& squared_frequencies);

/// ln |z| of the fastest motion zⁿ under the central difference of step `dt` [s], where
/// z − 2 + 1/z = −ω² dt².
[[nodiscard]] double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies,
                                     double dt);

}  // namespace tlsph

#pragma once
/// \file
/// What the operators of a state say about its motions: the whole spectrum of M⁻¹K, dense.

#include <complex>

#include "specimen.hpp"

namespace tlsph {

struct StateSpectrum {
  std::vector<std::complex<double>> squares;  ///< ω², largest modulus first [1/s²]
  double bound = 0.0;                         ///< critical step as a run computes it [s]
  double limit = 0.0;  ///< the true one: 2/ω_max, or with viscosity λ_max(Δt²K + 2ΔtC) = 4 [s]
  double growth = 0.0;  ///< largest Re(s) [1/s], zero where it is round-off
  Index negative = 0;   ///< ω² < 0 beyond round-off
  /// What runs are measured in: the bound, or where a material without waves has none worth the
  /// name, the step in which its fastest growth is resolved.
  [[nodiscard]] double critical() const {
    return bound > 0.0 && bound < 1.1 * limit ? bound : limit;
  }
  [[nodiscard]] Index below(double square) const;  ///< |ω²| < square
};
template <int D>
[[nodiscard]] StateSpectrum spectrum_of(const Specimen<D>& specimen);

/// The `count`-th smallest |ω²| [1/s²], from zero.
[[nodiscard]] double smallest_square(const StateSpectrum& spectrum, Index count);

}  // namespace tlsph

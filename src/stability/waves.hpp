#pragma once
/// \file
/// Waves of a method on the undeformed lattice, far from any boundary.

#include "specimen.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// Dispersion, its anisotropy and the waves without energy.
template <int D>
[[nodiscard]] WaveRow wave_row(const Subject& subject, const Method& method, double poisson);

}  // namespace tlsph

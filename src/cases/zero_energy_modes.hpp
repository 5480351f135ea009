#pragma once
/// \file
/// How many vibrations cost no energy though they are no rigid motion.

#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// Bars and sheets with and without stabiliser, of the case `dispersion`: on a torus, where modes
/// without energy are exactly so, and as free bodies. Leaves the lowest frequencies of the free
/// sheets in `modes.csv`.
void count_zero_energy_modes(CaseRun& run);

}  // namespace tlsph

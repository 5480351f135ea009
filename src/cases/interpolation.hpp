#pragma once
/// \file
/// The parts of the case `interpolation`.

#include <array>

#include "tlsph/kernels/families.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph::sampling {

inline constexpr ModifiedMollifier kernel{};  ///< the thesis's own
inline constexpr std::array supports = {1.5, 2.5, 3.5, 4.5, 5.5};
inline constexpr int layers = 6;  ///< of ghosts, enough for all supports

/// Figs 2.10–2.12: (x − ½)⁴ with and without ghosts, and how its errors fall.
void quartic(CaseRun& run);
/// Figs 2.13–2.16: amplitudes of sin x and its derivatives.
void sine(CaseRun& run);
/// Figs 2.17–2.20: falling edges.
void edges(CaseRun& run);
/// (2.46), (2.47): the modified SPH matrix.
void modified_matrix(CaseRun& run);

}  // namespace tlsph::sampling

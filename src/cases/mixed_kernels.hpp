#pragma once
/// \file
/// The parts of the case `mixed_kernels`.

#include <array>
#include <string_view>

#include "tlsph/kernels/families.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph::mixed {

/// The kernels of the Cranfield thesis, table 3, with its smoothing length 1.2 Δ.
inline constexpr std::array<std::string_view, 3> families = {"quadratic", "cubic-spline",
                                                             "wendland-c2"};
inline constexpr double support = 2.4;

inline AnyKernel kernel(std::string_view family) {
  return *kernel_by_name(family);
}

/// Figs 4-4, 4-5, 8-5, 8-6: the tensile instability under pairs of kernels.
void tension(CaseRun& run);
/// The same pairs as operators of the reference configuration.
void reference_pairs(CaseRun& run);
/// Fig. 8-4: a run whose strains and stresses pass through the mixed form.
void reinterpolated(CaseRun& run);

}  // namespace tlsph::mixed

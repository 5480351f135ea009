#pragma once
/// \file
/// The laws of a body's regions as a sweep applies them. Not for other rooms.

#include <vector>

#include "sweep_kernels.hpp"
#include "tlsph/dynamics/discretisation.hpp"

namespace tlsph::sweep {

/// The law of a region: vectorised kernels where there are some for its type, or point by point.
template <int D>
struct RegionLaw {
  LawKernels kernel;
  LawConstants constants;
  const AnyLaw<D>* any = nullptr;  ///< where there is no kernel
  bool linearised = false;         ///< that law at H = 0
};

/// One a region. The discretisation must outlive them. `linearised`: what every law is at H = 0.
template <int D>
[[nodiscard]] std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& discretisation,
                                                    const Kernels<D>& kernels, bool linearised);

/// The number of the region of every material point; empty if there is one region.
template <int D>
[[nodiscard]] std::vector<int> regions_of_points(const Discretisation<D>& discretisation);

}  // namespace tlsph::sweep

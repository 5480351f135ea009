#pragma once
/// \file
/// The laws of a body's regions as a sweep applies them.

#include <vector>

#include "loops.hpp"
#include "tlsph/formulations/discretisation.hpp"

namespace tlsph::sweep {

/// The law of a region with the inner loops of its type, or without, point by point.
template <int D>
struct RegionLaw {
  AnyLaw<D> law;
  const LawLoops* loops = nullptr;
  bool linearised = false;  ///< without loops: that law at H = 0

  /// What the loops ask for first.
  [[nodiscard]] const void* text() const;
};

/// One a region. `linearised`: what every law is at H = 0.
template <int D>
[[nodiscard]] std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& discretisation,
                                                    const Loops<D>& loops, bool linearised);

/// The number of the region of every material point; empty if there is one region.
template <int D>
[[nodiscard]] std::vector<int> regions_of_points(const Discretisation<D>& discretisation);

}  // namespace tlsph::sweep

#pragma once
/// \file
/// The laws of a body's regions as a sweep applies them.

#include <vector>

#include "loops.hpp"
#include "tlsph/dynamics/state.hpp"

namespace tlsph::sweep {

/// The law of a region with the inner loops of its type, or without, point by point. Fields are by
/// direction.
template <int D>
struct RegionLaw {
  AnyLaw<D> law;
  const LawLoops* loops = nullptr;
  bool linearised = false;  ///< without loops: that law at H = 0

  /// What the loops ask for first.
  [[nodiscard]] const void* text() const;
  /// H of `count` points becomes P, in place. False where a state has no stress.
  [[nodiscard]] bool stress(double* const* field, Index first, Index count) const;
  /// dP = ∂P/∂F : dH.
  void tangent(const double* const* H, const double* const* dH, double* const* dP,
               Index count) const;
  /// max λ_max(∂P/∂F at H − ∂P/∂F at `before`), at most that and at least zero [Pa]; `memory` of
  /// the points, now and before, for laws without loops.
  [[nodiscard]] double stiffening(const double* const* H, const float* const* before, Index first,
                                  Index count, const MemoryField& memory,
                                  const MemoryField& memory_before) const;
};

/// One a region. `linearised`: what every law is at H = 0.
template <int D>
[[nodiscard]] std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& discretisation,
                                                    const Loops<D>& loops, bool linearised);

/// The number of the region of every material point; empty if there is one region.
template <int D>
[[nodiscard]] std::vector<int> regions_of_points(const Discretisation<D>& discretisation);

}  // namespace tlsph::sweep

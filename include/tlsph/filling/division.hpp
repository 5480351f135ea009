#pragma once
/// \file
/// How a box is divided into whole cells.

#include <array>

#include "tlsph/core/error.hpp"
#include "tlsph/core/types.hpp"
#include "tlsph/geometry/shape.hpp"

namespace tlsph {

template <int D>
struct Division {
  Box<D> box;                ///< [m]
  std::array<int, D> cells;  ///< per direction, ≥ 1

  [[nodiscard]] Vector<D> spacing() const;  ///< lengths / cells [m]
  /// Coordinate [m] of lattice line i of direction a; the last one is exactly the upper bound.
  [[nodiscard]] double line(int a, int i) const;
};

/// The nearest whole division of the box to that spacing [m]. InputError, at `place`, if the
/// spacing is no positive number, would change by more than 1 % (names the nearest that fits), or
/// needs more than 2³¹ nodes.
template <int D>
[[nodiscard]] Division<D> divide(const Box<D>& box, double spacing, const Place& place = {});

/// Does that spacing [m] change by no more than 1 % in the nearest whole division of the box?
[[nodiscard]] bool divides(const Box<2>& box, double spacing);

}  // namespace tlsph

#pragma once
/// \file
/// The cross product of the plane.

#include "tlsph/core/types.hpp"

namespace tlsph {

/// a_x b_y − a_y b_x: positive where b lies to the left of a.
[[nodiscard]] inline double cross(const Vector<2>& a, const Vector<2>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace tlsph

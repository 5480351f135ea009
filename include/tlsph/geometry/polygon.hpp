#pragma once
/// \file
/// The cross product of the plane, and polygons as plain lists of corners: in order, closed
/// implicitly, lengths in metres. Counter-clockwise polygons have positive area.

#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// a_x b_y − a_y b_x: positive where b lies to the left of a.
[[nodiscard]] inline double cross(const Vector<2>& a, const Vector<2>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

using Corners = std::vector<Vector<2>>;

/// Points as the rows of a field; at least one.
[[nodiscard]] inline VectorField<2> as_rows(const std::vector<Vector<2>>& points) {
  return Eigen::Map<const VectorField<2>>(points.front().data(), static_cast<Index>(points.size()),
                                          2);
}

/// Area [m²], positive for counter-clockwise corners; 0 for fewer than three.
[[nodiscard]] double signed_area(const Corners& corners);

/// The part of a polygon where normal·X ≤ offset. A non-convex subject may come back with edges
/// that coincide; its area and moments are right all the same.
[[nodiscard]] Corners clip_half_plane(const Corners& subject, const Vector<2>& normal,
                                      double offset);

}  // namespace tlsph

#pragma once
/// \file
/// Polygons as plain lists of corners: area, moments and clipping. Corners in order, closed
/// implicitly, lengths in metres. Counter-clockwise polygons have positive area.

#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

using Corners = std::vector<Vector<2>>;

/// ∫ over the polygon of 1, X and X⊗X about the origin of the coordinates. All change sign with the
/// sense of the corners.
struct PolygonMoments {
  double area = 0.0;                     ///< ∫ dA [m²]
  Vector<2> first = Vector<2>::Zero();   ///< ∫ X dA [m³]
  Tensor<2> second = Tensor<2>::Zero();  ///< ∫ X⊗X dA [m⁴]
};

/// Moments of a simple polygon (Green's theorem on the fan of triangles about the first corner, so
/// that a small polygon far from the origin loses no digits in its area).
[[nodiscard]] PolygonMoments moments(const Corners& corners);

/// Area [m²], positive for counter-clockwise corners; 0 for fewer than three.
[[nodiscard]] double signed_area(const Corners& corners);

/// Centre of area. Asserts that the area is not zero.
[[nodiscard]] Vector<2> centroid(const Corners& corners);

/// The part of a polygon where normal·X ≤ offset. A non-convex subject may come back with edges
/// that coincide; its area and moments are right all the same.
[[nodiscard]] Corners clip_half_plane(const Corners& subject, const Vector<2>& normal,
                                      double offset);

/// Subject ∩ convex clip polygon (either sense), after Sutherland and Hodgman (1974). Empty if they
/// do not overlap.
[[nodiscard]] Corners clip_convex(const Corners& subject, const Corners& convex);

}  // namespace tlsph

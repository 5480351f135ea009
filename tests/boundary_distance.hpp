#pragma once
/// \file
/// Where a point lies with respect to the boundary of a shape.

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {

/// Point of the boundary (of holes too) closest to x.
inline Vector<1> closest_boundary_point(const Shape<1>& shape, const Vector<1>& x) {
  const Box<1> interval = bounding_box(shape);
  return x(0) - interval.lower(0) <= interval.upper(0) - x(0) ? interval.lower : interval.upper;
}

inline Vector<2> closest_boundary_point(const Shape<2>& shape, const Vector<2>& x) {
  return closest(outline(shape), x).point;
}

/// Distance to the boundary [m], positive inside.
template <int D>
double signed_distance(const Shape<D>& shape, const Vector<D>& x) {
  const double distance = (closest_boundary_point(shape, x) - x).norm();
  return depth(shape, x) >= 0.0 ? distance : -distance;
}

}  // namespace tlsph

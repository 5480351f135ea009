#pragma once
/// \file
/// Where a point lies with respect to the boundary of a shape.

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {

/// True in the closed set: boundary points, of holes too, belong to the shape. Tolerance 1e-10 of
/// the diagonal of the bounding box.
template <int D>
bool contains(const Shape<D>& shape, const Vector<D>& x) {
  const Box<D> box = bounding_box(shape);
  return depth(shape, x) >= -1e-10 * (box.upper - box.lower).norm();
}

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

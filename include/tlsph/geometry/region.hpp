#pragma once
/// \file
/// What shapes are like: their size, the depth of a point in them, their parts, whether they are
/// sound; and how they are made. Lengths in metres.

#include <string>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/core/types.hpp"
#include "tlsph/geometry/shape.hpp"

namespace tlsph {

/// Smallest box around the shape; of a difference, around its base.
template <int D>
[[nodiscard]] Box<D> bounding_box(const Shape<D>& shape);

/// A function that is positive inside, zero on the boundary and negative outside, continuous, at
/// most the distance to the boundary [m] (equal to it for boxes, discs and polygons).
template <int D>
[[nodiscard]] double depth(const Shape<D>& shape, const Vector<D>& x);

/// True in the closed set: boundary points, of holes too, belong to the shape. Tolerance 1e-10 of
/// the diagonal of the bounding box.
template <int D>
[[nodiscard]] bool contains(const Shape<D>& shape, const Vector<D>& x) {
  const Box<D> box = bounding_box(shape);
  return depth(shape, x) >= -1e-10 * (box.upper - box.lower).norm();
}

/// Length [m] or area [m²], in closed form for every shape (see geometry/outline.hpp).
template <int D>
[[nodiscard]] double area(const Shape<D>& shape);

/// Number of end points (2) in 1D, length of the boundary [m] in 2D, holes included.
template <int D>
[[nodiscard]] double boundary_measure(const Shape<D>& shape);

/// What holes are cut from: the shape itself if it is no difference.
[[nodiscard]] const Shape<2>& base_of(const Shape<2>& shape);
[[nodiscard]] inline const Shape<1>& base_of(const Shape<1>& shape) {
  return shape;
}

/// Everything cut from the base, outermost difference last.
[[nodiscard]] std::vector<Shape<2>> holes_of(const Shape<2>& shape);
[[nodiscard]] inline std::vector<Shape<1>> holes_of(const Shape<1>&) {
  return {};
}

/// Throws InputError, at `place`, if the shape is no body: a number that is not finite, an empty
/// interval or box, a radius ≤ 0, a polygon with fewer than three corners, coinciding neighbours,
/// crossing edges or no area, a hole that leaves nothing or cuts nothing.
template <int D>
void validate(const Shape<D>& shape, const Place& place = {});

/// A box as a shape.
template <int D>
[[nodiscard]] Shape<D> make_box(const Vector<D>& lower, const Vector<D>& upper);
[[nodiscard]] Shape<1> make_interval(double lower, double upper);
[[nodiscard]] Shape<2> make_disc(const Vector<2>& centre, double radius);
[[nodiscard]] Shape<2> make_polygon(std::vector<Vector<2>> corners);
[[nodiscard]] Shape<2> make_difference(Shape<2> base, std::vector<Shape<2>> holes);

}  // namespace tlsph

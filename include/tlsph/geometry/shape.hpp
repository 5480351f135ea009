#pragma once
/// \file
/// Regions of space a body is made of: an interval in 1D; boxes, discs, polygons and differences of
/// them in 2D. Lengths in metres, reference configuration.

#include <memory>
#include <variant>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// [lower, upper] per coordinate: an interval in 1D, a box in 2D.
template <int D>
struct Box {
  Vector<D> lower;
  Vector<D> upper;
};

struct Disc {
  Vector<2> centre;
  double radius = 0.0;
};

/// Simple polygon, corners in order (either sense), closed implicitly.
struct Polygon {
  std::vector<Vector<2>> corners;
};

template <int D>
struct Difference;

/// A shape in D dimensions.
template <int D>
struct Shape;

template <>
struct Shape<1> {
  std::variant<Box<1>> form;
};
template <>
struct Shape<2> {
  std::variant<Box<2>, Disc, Polygon, std::shared_ptr<const Difference<2>>> form;
};

/// The points of `base` that lie in none of `holes`.
template <>
struct Difference<2> {
  Shape<2> base;
  std::vector<Shape<2>> holes;
};

}  // namespace tlsph

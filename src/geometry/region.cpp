#include "tlsph/geometry/region.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tlsph/geometry/outline.hpp"

namespace tlsph {
namespace {

using DifferencePointer = std::shared_ptr<const Difference<2>>;

template <int D>
double box_depth(const Box<D>& box, const Vector<D>& x) {
  const Vector<D> outside = (box.lower - x).cwiseMax(x - box.upper);
  const double largest = outside.maxCoeff();
  return largest <= 0.0 ? -largest : -outside.cwiseMax(0.0).norm();
}

double polygon_depth(const Polygon& polygon, const Vector<2>& x) {
  const auto& corners = polygon.corners;
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const OutlinePiece edge{corners[k], corners[(k + 1) % corners.size()]};
    squared = std::min(squared, (edge.closest(x) - x).squaredNorm());
    // A ray to the right: each edge that crosses it changes sides.
    if ((edge.from.y() > x.y()) != (edge.to.y() > x.y())) {
      const double t = (x.y() - edge.from.y()) / (edge.to.y() - edge.from.y());
      if (x.x() < edge.from.x() + t * (edge.to.x() - edge.from.x())) inside = !inside;
    }
  }
  return inside ? std::sqrt(squared) : -std::sqrt(squared);
}

}  // namespace

template <>
Box<1> bounding_box(const Shape<1>& shape) {
  return std::get<Box<1>>(shape.form);
}

template <>
Box<2> bounding_box(const Shape<2>& shape) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form)) return *box;
  if (const auto* disc = std::get_if<Disc>(&shape.form))
    return {disc->centre.array() - disc->radius, disc->centre.array() + disc->radius};
  if (const auto* polygon = std::get_if<Polygon>(&shape.form)) {
    assert(!polygon->corners.empty());
    Box<2> box{polygon->corners.front(), polygon->corners.front()};
    for (const auto& corner : polygon->corners) {
      box.lower = box.lower.cwiseMin(corner);
      box.upper = box.upper.cwiseMax(corner);
    }
    return box;
  }
  return bounding_box(std::get<DifferencePointer>(shape.form)->base);
}

template <>
double depth(const Shape<1>& shape, const Vector<1>& x) {
  return box_depth(std::get<Box<1>>(shape.form), x);
}

template <>
double depth(const Shape<2>& shape, const Vector<2>& x) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form)) return box_depth(*box, x);
  if (const auto* disc = std::get_if<Disc>(&shape.form))
    return disc->radius - (x - disc->centre).norm();
  if (const auto* polygon = std::get_if<Polygon>(&shape.form)) return polygon_depth(*polygon, x);
  const auto& difference = *std::get<DifferencePointer>(shape.form);
  double least = depth(difference.base, x);
  for (const auto& hole : difference.holes) least = std::min(least, -depth(hole, x));
  return least;
}

template <>
double area(const Shape<1>& shape) {
  const auto& interval = std::get<Box<1>>(shape.form);
  return interval.upper(0) - interval.lower(0);
}

template <>
double area(const Shape<2>& shape) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form)) return (box->upper - box->lower).prod();
  return enclosed_area(outline(shape));
}

template <>
double boundary_measure(const Shape<1>&) {
  return 2.0;
}

template <>
double boundary_measure(const Shape<2>& shape) {
  double length = 0.0;
  for (const auto& piece : outline(shape)) length += piece.length();
  return length;
}

const Shape<2>& base_of(const Shape<2>& shape) {
  const auto* difference = std::get_if<DifferencePointer>(&shape.form);
  return difference ? base_of((*difference)->base) : shape;
}

std::vector<Shape<2>> holes_of(const Shape<2>& shape) {
  const auto* difference = std::get_if<DifferencePointer>(&shape.form);
  if (!difference) return {};
  std::vector<Shape<2>> holes = holes_of((*difference)->base);
  holes.insert(holes.end(), (*difference)->holes.begin(), (*difference)->holes.end());
  return holes;
}

template <int D>
Shape<D> make_box(const Vector<D>& lower, const Vector<D>& upper) {
  return Shape<D>{Box<D>{lower, upper}};
}

Shape<1> make_interval(double lower, double upper) {
  return make_box<1>(Vector<1>(lower), Vector<1>(upper));
}

Shape<2> make_disc(const Vector<2>& centre, double radius) {
  return Shape<2>{Disc{centre, radius}};
}

Shape<2> make_polygon(std::vector<Vector<2>> corners) {
  return Shape<2>{Polygon{std::move(corners)}};
}

Shape<2> make_difference(Shape<2> base, std::vector<Shape<2>> holes) {
  return Shape<2>{
      std::make_shared<const Difference<2>>(Difference<2>{std::move(base), std::move(holes)})};
}

template Shape<1> make_box(const Vector<1>&, const Vector<1>&);
template Shape<2> make_box(const Vector<2>&, const Vector<2>&);

}  // namespace tlsph

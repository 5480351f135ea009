#include <fmt/core.h>
#include <cmath>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/polygon.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {

template <>
void validate(const Shape<2>& shape, const Place& place);  // bases and holes are shapes again

namespace {

constexpr char axis_name[] = {'x', 'y', 'z'};

template <int D>
void validate_box(const Box<D>& box, const Place& place) {
  if (!box.lower.allFinite() || !box.upper.allFinite())
    throw InputError(place, "bounds must be finite numbers");
  for (int a = 0; a < D; ++a)
    if (!(box.lower(a) < box.upper(a)))
      throw InputError(place,
                       fmt::format("{} is empty: lower bound {} is not below upper bound {}{}",
                                   D == 1 ? "interval" : "box", box.lower(a), box.upper(a),
                                   D == 1 ? std::string() : fmt::format(" in {}", axis_name[a])));
}

void validate_disc(const Disc& disc, const Place& place) {
  if (!disc.centre.allFinite() || !std::isfinite(disc.radius))
    throw InputError(place, "centre and radius of a disc must be finite numbers");
  if (disc.radius <= 0.0)
    throw InputError(place,
                     fmt::format("radius of a disc must be greater than 0, not {}", disc.radius));
}

/// Do segments ab and cd have a point in common? Touching counts, within the tolerance [m].
bool meet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d,
          double tolerance) {
  const auto close = [&](const Vector<2>& p, const Vector<2>& q, const Vector<2>& x) {
    return (OutlinePiece{p, q}.closest(x) - x).norm() <= tolerance;
  };
  if (close(a, b, c) || close(a, b, d) || close(c, d, a) || close(c, d, b)) return true;
  return (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0) &&
         (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
}

void validate_polygon(const Polygon& polygon, const Place& place) {
  const auto& corners = polygon.corners;
  const std::size_t n = corners.size();
  if (n < 3) throw InputError(place, fmt::format("a polygon needs at least 3 corners, not {}", n));
  for (const auto& corner : corners)
    if (!corner.allFinite()) throw InputError(place, "corners of a polygon must be finite numbers");
  const Box<2> box = bounding_box(Shape<2>{polygon});
  const double size = (box.upper - box.lower).norm();
  for (std::size_t k = 0; k < n; ++k)
    if ((corners[(k + 1) % n] - corners[k]).norm() <= 1e-9 * size)
      throw InputError(
          place, fmt::format("corners {} and {} of the polygon coincide; leave one out", k + 1,
                             (k + 1) % n + 1));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours
      if (meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n], 1e-9 * size))
        throw InputError(place, fmt::format("edges {} and {} of the polygon cross or touch; its "
                                            "corners must go around it once, in order",
                                            i + 1, j + 1));
    }
  if (std::abs(signed_area(corners)) <= 1e-9 * size * size)
    throw InputError(place, "the polygon has no area: its corners lie on one line");
}

void validate_difference(const Difference<2>& difference, const Place& place) {
  validate(difference.base, place);
  if (difference.holes.empty())
    throw InputError(place,
                     "a difference needs at least one hole; without one give the base alone");
  const double whole = area(difference.base);
  for (std::size_t k = 0; k < difference.holes.size(); ++k) {
    const Shape<2>& hole = difference.holes[k];
    validate(hole, place);
    const double left = area(make_difference(difference.base, {hole}));
    if (left <= 1e-9 * whole)
      throw InputError(place, fmt::format("hole {} swallows the whole body", k + 1));
    if (whole - left <= 1e-9 * std::min(whole, area(hole)))
      throw InputError(place, fmt::format("hole {} lies outside the body and cuts nothing", k + 1));
  }
  if (area(make_difference(difference.base, difference.holes)) <= 1e-9 * whole)
    throw InputError(place, "the holes together leave nothing of the body");
}

}  // namespace

template <>
void validate(const Shape<1>& shape, const Place& place) {
  validate_box(std::get<Box<1>>(shape.form), place);
}

template <>
void validate(const Shape<2>& shape, const Place& place) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form)) return validate_box(*box, place);
  if (const auto* disc = std::get_if<Disc>(&shape.form)) return validate_disc(*disc, place);
  if (const auto* polygon = std::get_if<Polygon>(&shape.form))
    return validate_polygon(*polygon, place);
  const auto& difference = std::get<std::shared_ptr<const Difference<2>>>(shape.form);
  if (!difference) throw InputError(place, "a difference needs a base and at least one hole");
  validate_difference(*difference, place);
}

}  // namespace tlsph

#include "tlsph/geometry/outline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "tlsph/geometry/polygon.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
/// Points closer than this share of the size are one point.
constexpr double merge_share = 1e-10;
/// How far beside a piece we look for the body.
constexpr double probe_share = 1e-7;

OutlinePiece arc(const Vector<2>& centre, double radius, double start, double sweep) {
  OutlinePiece piece{Vector<2>(), Vector<2>(), centre, radius, start, sweep};
  piece.from = piece.at(0.0);
  piece.to = piece.at(1.0);
  return piece;
}

/// Whole boundary curves of every primitive of the shape.
void collect(const Shape<2>& shape, std::vector<OutlinePiece>& curves) {
  if (const auto* box = std::get_if<Box<2>>(&shape.form)) {
    const Vector<2> a = box->lower, c = box->upper, b(c.x(), a.y()), d(a.x(), c.y());
    curves.insert(curves.end(), {{a, b}, {b, c}, {c, d}, {d, a}});
  } else if (const auto* disc = std::get_if<Disc>(&shape.form)) {
    curves.push_back(arc(disc->centre, disc->radius, 0.0, two_pi));
  } else if (const auto* polygon = std::get_if<Polygon>(&shape.form)) {
    const auto& corners = polygon->corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
      curves.push_back({corners[k], corners[(k + 1) % corners.size()]});
  } else {
    const auto& difference = *std::get<std::shared_ptr<const Difference<2>>>(shape.form);
    collect(difference.base, curves);
    for (const auto& hole : difference.holes) collect(hole, curves);
  }
}

/// Parameter of the point of the curve closest to x (x lies on or near the curve).
double parameter(const OutlinePiece& curve, const Vector<2>& x) {
  if (!curve.is_arc()) {
    const Vector<2> edge = curve.to - curve.from;
    return edge.dot(x - curve.from) / edge.squaredNorm();
  }
  const Vector<2> arm = x - curve.centre;
  const double turn = (std::atan2(arm.y(), arm.x()) - curve.start) / two_pi;
  return turn - std::floor(turn);  // whole circles only
}

/// Points where a line (through a segment) meets a circle; a touch counts as one.
std::vector<Vector<2>> line_circle(const OutlinePiece& line, const OutlinePiece& circle,
                                   double tolerance) {
  const Vector<2> along = (line.to - line.from).normalized();
  const Vector<2> foot = line.from + along.dot(circle.centre - line.from) * along;
  const double gap = (foot - circle.centre).norm();
  if (gap > circle.radius + tolerance) return {};
  const double half = std::sqrt(std::max(0.0, (circle.radius - gap) * (circle.radius + gap)));
  return {foot - half * along, foot + half * along};
}

std::vector<Vector<2>> circle_circle(const OutlinePiece& a, const OutlinePiece& b,
                                     double tolerance) {
  const Vector<2> axis = b.centre - a.centre;
  const double distance = axis.norm();
  if (distance <= tolerance || distance > a.radius + b.radius + tolerance ||
      distance < std::abs(a.radius - b.radius) - tolerance)
    return {};
  const double foot =
      (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2.0 * distance);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - foot * foot));
  const Vector<2> middle = a.centre + foot / distance * axis;
  const Vector<2> side = half / distance * Vector<2>(-axis.y(), axis.x());
  return {middle - side, middle + side};
}

/// Points where curve a may have to be cut because of curve b.
std::vector<Vector<2>> meetings(const OutlinePiece& a, const OutlinePiece& b, double tolerance) {
  if (a.is_arc() && b.is_arc()) return circle_circle(a, b, tolerance);
  if (a.is_arc()) return line_circle(b, a, tolerance);
  if (b.is_arc()) return line_circle(a, b, tolerance);
  std::vector<Vector<2>> points = {b.from, b.to};  // collinear overlaps end there
  const Vector<2> edge_a = a.to - a.from, edge_b = b.to - b.from;
  const double determinant = cross(edge_a, edge_b);
  if (std::abs(determinant) > merge_share * edge_a.norm() * edge_b.norm())
    points.emplace_back(a.from + cross(b.from - a.from, edge_b) / determinant * edge_a);
  return points;
}

bool near(const OutlinePiece& curve, const Vector<2>& x, double tolerance) {
  return (curve.closest(x) - x).norm() <= tolerance;
}

OutlinePiece part(const OutlinePiece& curve, double t0, double t1) {
  if (curve.is_arc())
    return arc(curve.centre, curve.radius, curve.start + t0 * curve.sweep, (t1 - t0) * curve.sweep);
  return {curve.at(t0), curve.at(t1)};
}

OutlinePiece reversed(const OutlinePiece& piece) {
  OutlinePiece back = piece;
  std::swap(back.from, back.to);
  back.start = piece.start + piece.sweep;
  back.sweep = -piece.sweep;
  return back;
}

/// Curve number k cut at every meeting with the others.
std::vector<OutlinePiece> cut(const std::vector<OutlinePiece>& curves, std::size_t k,
                              double tolerance) {
  const OutlinePiece& curve = curves[k];
  const double step = tolerance / curve.length();
  std::vector<double> cuts;
  for (std::size_t other = 0; other < curves.size(); ++other) {
    if (other == k) continue;
    for (const auto& point : meetings(curve, curves[other], tolerance)) {
      // A touch of line and circle spreads over √tolerance; only points on both curves count.
      if (!near(curve, point, tolerance) || !near(curves[other], point, tolerance)) continue;
      cuts.push_back(parameter(curve, point));
    }
  }
  if (curve.is_arc()) {
    std::sort(cuts.begin(), cuts.end());
    if (cuts.empty()) return {curve};
    cuts.push_back(cuts.front() + 1.0);  // once around
  } else {
    cuts.push_back(0.0);
    cuts.push_back(1.0);
    std::sort(cuts.begin(), cuts.end());
  }
  std::vector<OutlinePiece> pieces;
  double last = cuts.front();
  for (const double t : cuts) {
    if (t - last <= step) continue;
    pieces.push_back(part(curve, last, t));
    last = t;
  }
  return pieces;
}

}  // namespace

Vector<2> OutlinePiece::at(double t) const {
  if (!is_arc()) return from + t * (to - from);
  const double angle = start + t * sweep;
  return centre + radius * Vector<2>(std::cos(angle), std::sin(angle));
}

Vector<2> OutlinePiece::normal_at(const Vector<2>& x) const {
  if (is_arc()) return std::copysign(1.0, sweep) * (x - centre) / radius;
  const Vector<2> along = (to - from).normalized();
  return {along.y(), -along.x()};
}

double OutlinePiece::length() const {
  return is_arc() ? radius * std::abs(sweep) : (to - from).norm();
}

Vector<2> OutlinePiece::closest(const Vector<2>& x) const {
  if (!is_arc()) {
    const Vector<2> edge = to - from;
    return from + std::clamp(edge.dot(x - from) / edge.squaredNorm(), 0.0, 1.0) * edge;
  }
  const Vector<2> arm = x - centre;
  double turn = std::copysign(1.0, sweep) * (std::atan2(arm.y(), arm.x()) - start);
  turn -= two_pi * std::floor(turn / two_pi);
  if (turn <= std::abs(sweep) && arm.squaredNorm() > 0.0) return centre + radius * arm.normalized();
  return (x - from).squaredNorm() <= (x - to).squaredNorm() ? from : to;
}

Foot closest(const std::vector<OutlinePiece>& pieces, const Vector<2>& x) {
  Foot foot;
  for (const OutlinePiece& piece : pieces) {
    const Vector<2> point = piece.closest(x);
    const double squared = (point - x).squaredNorm();
    if (squared < foot.squared) foot = {&piece, point, squared};
  }
  return foot;
}

Vector<2> point_along(const OutlineLoop& pieces, double distance) {
  for (const OutlinePiece& piece : pieces) {
    const double length = piece.length();
    if (distance <= length) return piece.at(distance / length);
    distance -= length;
  }
  return pieces.back().to;
}

std::vector<OutlinePiece> outline(const Shape<2>& shape) {
  std::vector<OutlinePiece> curves;
  collect(shape, curves);
  const Box<2> box = bounding_box(shape);
  const double size = (box.upper - box.lower).norm();
  const double tolerance = merge_share * size;
  const double aside = probe_share * size;

  std::vector<OutlinePiece> pieces;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (const auto& piece : cut(curves, k, tolerance)) {
      const auto repeats = [&](const OutlinePiece& earlier) {  // an earlier curve runs along it
        return near(earlier, piece.at(0.5), tolerance) && near(earlier, piece.at(0.3), tolerance);
      };
      if (std::any_of(curves.begin(), curves.begin() + static_cast<std::ptrdiff_t>(k), repeats))
        continue;
      const Vector<2> middle = piece.at(0.5), right = aside * piece.normal(0.5);
      const bool body_left = depth(shape, Vector<2>(middle - right)) > 0.0;
      const bool body_right = depth(shape, Vector<2>(middle + right)) > 0.0;
      if (body_left != body_right) pieces.push_back(body_left ? piece : reversed(piece));
    }
  }
  return pieces;
}

std::vector<OutlineLoop> outline_loops(const Shape<2>& shape) {
  std::vector<OutlinePiece> pieces = outline(shape);
  std::vector<OutlineLoop> loops;
  while (!pieces.empty()) {
    OutlineLoop loop = {pieces.back()};
    pieces.pop_back();
    for (;;) {
      const Vector<2> end = loop.back().to;
      // Ends that ought to be one point are; the nearest start is robust against their rounding.
      const auto gap = [&](const OutlinePiece& piece) { return (piece.from - end).squaredNorm(); };
      const auto next =
          std::min_element(pieces.begin(), pieces.end(),
                           [&](const auto& a, const auto& b) { return gap(a) < gap(b); });
      if (next == pieces.end() || gap(*next) >= gap(loop.front())) break;
      loop.push_back(*next);
      pieces.erase(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

bool is_corner(const OutlinePiece& piece, const OutlinePiece& next) {
  constexpr double cosine = 0.94;  // 20°
  return piece.normal(1.0).dot(next.normal(0.0)) < cosine;
}

std::vector<OutlineLoop> sections(const OutlineLoop& loop, const Breaks& breaks) {
  std::size_t first = 0;  // the piece after a break
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (breaks(loop[(k + loop.size() - 1) % loop.size()], loop[k])) first = k;
  std::vector<OutlineLoop> result;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const OutlinePiece& piece = loop[(first + k) % loop.size()];
    if (k == 0 || breaks(result.back().back(), piece)) result.emplace_back();
    result.back().push_back(piece);
  }
  return result;
}

double enclosed_area(const std::vector<OutlinePiece>& pieces) {
  if (pieces.empty()) return 0.0;
  const Vector<2> origin = pieces.front().from;  // near the shape: no digits lost far from zero
  double twice = 0.0;
  for (const auto& piece : pieces) {
    if (piece.is_arc())  // X = c + r e: X×dX = r² dφ + c×dX
      twice += piece.radius * piece.radius * piece.sweep +
               cross(piece.centre - origin, piece.to - piece.from);
    else
      twice += cross(piece.from - origin, piece.to - origin);
  }
  return 0.5 * twice;
}

}  // namespace tlsph

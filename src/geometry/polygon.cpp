#include "tlsph/geometry/polygon.hpp"

#include <cassert>
#include <cmath>

#include "tlsph/geometry/cross.hpp"

namespace tlsph {
namespace {

/// Calls action(a, b) with the two far corners, relative to the first one, of each fan triangle.
template <class Action>
void for_each_fan_triangle(const Corners& corners, Action action) {
  for (std::size_t k = 2; k < corners.size(); ++k)
    action(Vector<2>(corners[k - 1] - corners[0]), Vector<2>(corners[k] - corners[0]));
}

}  // namespace

double signed_area(const Corners& corners) {
  double twice = 0.0;
  for_each_fan_triangle(corners, [&](const auto& a, const auto& b) { twice += cross(a, b); });
  return 0.5 * twice;
}

PolygonMoments moments(const Corners& corners) {
  // Triangle (0, a, b) of area A: ∫X = A (a+b)/3, ∫X⊗X = A/12 (a⊗a + b⊗b + (a+b)⊗(a+b)).
  PolygonMoments m;
  for_each_fan_triangle(corners, [&](const auto& a, const auto& b) {
    const double area = 0.5 * cross(a, b);
    const Vector<2> sum = a + b;
    m.area += area;
    m.first += area / 3.0 * sum;
    m.second += area / 12.0 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
  });
  if (corners.empty()) return m;
  // Shift from the first corner O to the origin: X = O + Y.
  const Vector<2>& o = corners[0];
  m.second += o * m.first.transpose() + m.first * o.transpose() + m.area * o * o.transpose();
  m.first += m.area * o;
  return m;
}

Vector<2> centroid(const Corners& corners) {
  assert(!corners.empty());
  double area = 0.0;
  Vector<2> first = Vector<2>::Zero();
  for_each_fan_triangle(corners, [&](const auto& a, const auto& b) {
    area += 0.5 * cross(a, b);
    first += cross(a, b) / 6.0 * (a + b);
  });
  assert(area != 0.0);
  return corners[0] + first / area;
}

Corners clip_half_plane(const Corners& subject, const Vector<2>& normal, double offset) {
  Corners kept;
  kept.reserve(subject.size() + 1);
  for (std::size_t k = 0; k < subject.size(); ++k) {
    const Vector<2>& a = subject[k];
    const Vector<2>& b = subject[(k + 1) % subject.size()];
    const double height_a = normal.dot(a) - offset;
    const double height_b = normal.dot(b) - offset;
    if (height_a <= 0.0) kept.push_back(a);
    if ((height_a < 0.0 && height_b > 0.0) || (height_a > 0.0 && height_b < 0.0))
      kept.push_back(a + height_a / (height_a - height_b) * (b - a));
  }
  if (kept.size() < 3) kept.clear();
  return kept;
}

Corners clip_convex(const Corners& subject, const Corners& convex) {
  const double sense = std::copysign(1.0, signed_area(convex));
  Corners kept = subject;
  for (std::size_t k = 0; k < convex.size() && !kept.empty(); ++k) {
    const Vector<2> edge = convex[(k + 1) % convex.size()] - convex[k];
    const Vector<2> outward = sense * Vector<2>(edge.y(), -edge.x());
    kept = clip_half_plane(kept, outward, outward.dot(convex[k]));
  }
  return kept;
}

}  // namespace tlsph

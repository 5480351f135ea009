#pragma once
/// \file
/// Random simple polygons that a lattice of spacing 1 has to fill: interior angles from 20° to
/// 340°, edges of at least two spacings, edges without a common corner at least two spacings apart.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "property/bodies.hpp"

namespace tlsph::property {

using Corners = std::vector<Vector<2>>;

inline double cross(const Vector<2>& a, const Vector<2>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline double distance(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b) {
  const Vector<2> edge = b - a;
  return (a + std::clamp(edge.dot(x - a) / edge.squaredNorm(), 0.0, 1.0) * edge - x).norm();
}

/// Distance of the segments ab and cd, 0 if they meet.
inline double gap(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d) {
  if (cross(b - a, c - a) * cross(b - a, d - a) <= 0.0 &&
      cross(d - c, a - c) * cross(d - c, b - c) <= 0.0)
    return 0.0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

inline bool is_fillable(const Corners& corners) {
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vector<2>&here = corners[k], &next = corners[(k + 1) % n];
    const Vector<2> in = here - corners[(k + n - 1) % n], out = next - here;
    const double turn = std::atan2(cross(in, out), in.dot(out)) * 180.0 / std::numbers::pi;
    if (out.norm() < 2.0 || std::abs(turn) > 160.0) return false;
    for (std::size_t j = k + 2; j < n; ++j)
      if ((j + 1) % n != k && gap(here, next, corners[j], corners[(j + 1) % n]) < 2.0) return false;
  }
  return true;
}

/// Corners counter-clockwise: stars, tapered quadrilaterals, rectangles without a corner,
/// triangles, bent L-shapes, 3 to 100 spacings across; two of five of them turned.
inline Corners random_polygon(Random& random) {
  const auto between = [&](double from, double to) {
    return from + 0.5 * (to - from) * (random() + 1.0);
  };
  const auto polar = [](double radius, double angle) {
    return Vector<2>(radius * std::cos(angle), radius * std::sin(angle));
  };
  for (;;) {
    const double size = std::exp(between(std::log(2.5), std::log(24.0)));
    const double width = size * between(1.0, 3.0);
    Corners corners;
    switch (static_cast<int>(between(0.0, 7.0))) {
      case 0: {
        std::vector<double> angles(static_cast<std::size_t>(between(3.0, 9.0)));
        for (double& angle : angles) angle = between(0.0, 2.0 * std::numbers::pi);
        std::ranges::sort(angles);
        for (const double angle : angles) corners.push_back(polar(size * between(0.3, 1.0), angle));
        break;
      }
      case 1:
        corners = {{0.0, 0.0},
                   {width, between(-0.3, 0.5) * size},
                   {width, between(0.6, 1.4) * size},
                   {0.0, size}};
        break;
      case 2:
        corners = {{0.0, 0.0},
                   {width, 0.0},
                   {width, size * between(0.1, 0.9)},
                   {width * between(0.2, 0.95), size},
                   {0.0, size}};
        break;
      case 3:
        for (int k = 0; k < 3; ++k) corners.emplace_back(between(0.0, size), between(0.0, size));
        break;
      case 4: {
        const double x = between(0.2, 0.8) * width, y = between(0.2, 0.8) * size;
        corners = {{0.0, 0.0},
                   {width, 0.0},
                   {width, y},
                   {x, y + between(-0.2, 0.2) * size},
                   {x + between(-0.2, 0.2) * width, size},
                   {0.0, size}};
        if (random() < 0.0)
          for (auto& corner : corners) corner += 0.1 * size * Vector<2>(random(), random());
        break;
      }
      case 5: {
        const double depth = between(-0.9, 2.0) * size;  // of a notch, or height of a spike
        const double half = std::abs(depth) * std::tan(between(0.174, 0.6));
        const double middle = between(0.2, 0.8) * width;
        corners = {{0.0, 0.0},
                   {width, 0.0},
                   {width, size},
                   {middle + half, size},
                   {middle + 0.3 * half * random(), size + depth},
                   {middle - half, size},
                   {0.0, size}};
        break;
      }
      default: {
        const auto count = static_cast<int>(between(5.0, 17.0));
        for (int k = 0; k < count; ++k)
          corners.push_back(polar(size * between(0.25, 1.0),
                                  2.0 * std::numbers::pi * (k + 0.45 * random()) / count));
      }
    }
    if (random() < -0.2) {
      const Tensor<2> turn = rotation(between(0.0, 2.0 * std::numbers::pi));
      for (auto& corner : corners) corner = turn * corner;
    }
    double twice = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k)
      twice += cross(corners[k], corners[(k + 1) % corners.size()]);
    if (twice < 0.0) std::ranges::reverse(corners);
    if (is_fillable(corners)) return corners;
  }
}

}  // namespace tlsph::property

#include "tlsph/geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tlsph {
namespace {

Corners rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// ∫ over the polygon of 1, X and X⊗X.
struct PolygonMoments {
  double area = 0.0;
  Vector<2> first = Vector<2>::Zero();
  Tensor<2> second = Tensor<2>::Zero();
};

/// Triangle (0, a, b) of area A: ∫X = A (a+b)/3, ∫X⊗X = A/12 (a⊗a + b⊗b + (a+b)⊗(a+b)).
PolygonMoments moments(const Corners& corners) {
  PolygonMoments m;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double area = 0.5 * cross(a, b);
    const Vector<2> sum = a + b;
    m.area += area;
    m.first += area / 3.0 * sum;
    m.second += area / 12.0 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
  }
  return m;
}

TEST(Polygon, SenseGivesTheSign) {
  Corners corners = rectangle(0, 0, 2, 1);
  EXPECT_DOUBLE_EQ(signed_area(corners), 2.0);
  std::reverse(corners.begin(), corners.end());
  EXPECT_DOUBLE_EQ(signed_area(corners), -2.0);
  EXPECT_EQ(signed_area({{0, 0}, {1, 1}}), 0.0);
}

TEST(Polygon, AreaKeepsItsDigitsFarFromTheOrigin) {
  const double far = 1e6, side = 0x1p-10;
  EXPECT_DOUBLE_EQ(signed_area(rectangle(far, far, far + side, far + side)), side * side);
}

TEST(Polygon, HalfPlaneCutsACornerOff) {
  const Corners kept = clip_half_plane(rectangle(0, 0, 1, 1), {1, 1}, 1.5);
  EXPECT_EQ(kept.size(), 5u);
  EXPECT_DOUBLE_EQ(signed_area(kept), 1.0 - 0.125);
}

TEST(Polygon, ClippingKeepsMomentsOfTheParts) {
  // A polygon and the two halves of any cut have the same moments.
  const Corners whole = {{0, 0}, {3, 0.5}, {2.5, 2}, {1, 1.2}, {0.2, 2.5}};
  const Vector<2> normal(0.6, 0.8);
  const PolygonMoments all = moments(whole);
  const PolygonMoments below = moments(clip_half_plane(whole, normal, 1.5));
  const PolygonMoments above = moments(clip_half_plane(whole, -normal, -1.5));
  EXPECT_GT(below.area, 0.1);
  EXPECT_GT(above.area, 0.1);
  EXPECT_NEAR(below.area + above.area, all.area, 1e-14);
  EXPECT_NEAR((below.first + above.first - all.first).norm(), 0.0, 1e-14);
  EXPECT_NEAR((below.second + above.second - all.second).norm(), 0.0, 1e-14);
}

TEST(Polygon, NothingIsLeftWithoutOverlap) {
  EXPECT_TRUE(clip_half_plane(rectangle(0, 0, 1, 1), {1, 0}, -0.5).empty());
}

}  // namespace
}  // namespace tlsph

#include "tlsph/geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tlsph {
namespace {

Corners rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Polygon, MomentsOfARectangleAreTheTextbookOnes) {
  // ∫x = A x̄, ∫x² = A (x̄² + b²/12), ∫xy = A x̄ ȳ.
  const PolygonMoments m = moments(rectangle(1, 2, 3, 5));
  EXPECT_DOUBLE_EQ(m.area, 6.0);
  EXPECT_DOUBLE_EQ(m.first.x(), 6.0 * 2.0);
  EXPECT_DOUBLE_EQ(m.first.y(), 6.0 * 3.5);
  EXPECT_DOUBLE_EQ(m.second(0, 0), 6.0 * (4.0 + 4.0 / 12.0));
  EXPECT_DOUBLE_EQ(m.second(1, 1), 6.0 * (12.25 + 9.0 / 12.0));
  EXPECT_DOUBLE_EQ(m.second(0, 1), 6.0 * 7.0);
  EXPECT_DOUBLE_EQ(m.second(1, 0), m.second(0, 1));
}

TEST(Polygon, MomentsOfTheUnitTriangle) {
  const PolygonMoments m = moments({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_DOUBLE_EQ(m.area, 1.0 / 2.0);
  EXPECT_DOUBLE_EQ(m.first.x(), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(m.second(0, 0), 1.0 / 12.0);
  EXPECT_DOUBLE_EQ(m.second(0, 1), 1.0 / 24.0);
}

TEST(Polygon, SenseGivesTheSign) {
  Corners corners = rectangle(0, 0, 2, 1);
  EXPECT_DOUBLE_EQ(signed_area(corners), 2.0);
  std::reverse(corners.begin(), corners.end());
  EXPECT_DOUBLE_EQ(signed_area(corners), -2.0);
  EXPECT_DOUBLE_EQ(moments(corners).first.x(), -2.0);
  EXPECT_EQ(signed_area({{0, 0}, {1, 1}}), 0.0);
}

TEST(Polygon, AreaKeepsItsDigitsFarFromTheOrigin) {
  const double far = 1e6, side = 0x1p-10;
  EXPECT_DOUBLE_EQ(signed_area(rectangle(far, far, far + side, far + side)), side * side);
}

TEST(Polygon, CentroidOfAnL) {
  // Two unit squares on the x axis and one on top of the first: centres (0.5, 0.5), (1.5, 0.5),
  // (0.5, 1.5).
  const Vector<2> c = centroid({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  EXPECT_NEAR(c.x(), 2.5 / 3.0, 1e-15);
  EXPECT_NEAR(c.y(), 2.5 / 3.0, 1e-15);
}

TEST(Polygon, HalfPlaneCutsACornerOff) {
  const Corners kept = clip_half_plane(rectangle(0, 0, 1, 1), {1, 1}, 1.5);
  EXPECT_EQ(kept.size(), 5u);
  EXPECT_DOUBLE_EQ(signed_area(kept), 1.0 - 0.125);
}

TEST(Polygon, ClippingByAConvexPolygonOfEitherSense) {
  const Corners diamond = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};
  const Corners reversed(diamond.rbegin(), diamond.rend());
  // The lower left quarter square [0,1]² loses the triangle below x + y = 1.
  EXPECT_DOUBLE_EQ(signed_area(clip_convex(rectangle(0, 0, 1, 1), diamond)), 0.5);
  EXPECT_DOUBLE_EQ(signed_area(clip_convex(rectangle(0, 0, 1, 1), reversed)), 0.5);
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
  EXPECT_TRUE(clip_convex(rectangle(0, 0, 1, 1), rectangle(2, 0, 3, 1)).empty());
  EXPECT_TRUE(clip_half_plane(rectangle(0, 0, 1, 1), {1, 0}, -0.5).empty());
}

TEST(Polygon, ClippingByACoveringPolygonChangesNothing) {
  EXPECT_EQ(clip_convex(rectangle(0, 0, 1, 1), rectangle(0, -1, 2, 1)), rectangle(0, 0, 1, 1));
}

}  // namespace
}  // namespace tlsph

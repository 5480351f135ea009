#include "tlsph/geometry/region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "boundary_distance.hpp"
#include "tlsph/geometry/outline.hpp"

namespace tlsph {
namespace {

using std::numbers::pi;

Shape<2> square(double x, double y, double side) {
  return make_box<2>({x, y}, {x + side, y + side});
}

Shape<2> l_shape() {
  return make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
}

/// Area of the circular segment beyond a chord at distance d from the centre.
double cap(double radius, double d) {
  return radius * radius * std::acos(d / radius) - d * std::sqrt(radius * radius - d * d);
}

struct AreaCase {
  const char* name;
  Shape<2> shape;
  double area;
  double perimeter;
};

class Areas : public testing::TestWithParam<AreaCase> {};

TEST_P(Areas, AreExact) {
  EXPECT_NEAR(area(GetParam().shape), GetParam().area, 1e-13 * GetParam().area);
}

TEST_P(Areas, PerimetersAreExact) {
  EXPECT_NEAR(boundary_measure(GetParam().shape), GetParam().perimeter,
              1e-13 * GetParam().perimeter);
}

TEST_P(Areas, OutlineKeepsTheBodyOnItsLeft) {
  for (const auto& piece : outline(GetParam().shape)) {
    EXPECT_FALSE(contains(GetParam().shape, Vector<2>(piece.at(0.4) + 1e-6 * piece.normal(0.4))));
    EXPECT_TRUE(contains(GetParam().shape, Vector<2>(piece.at(0.4) - 1e-6 * piece.normal(0.4))));
  }
}

/// Each closed form is one line of school geometry.
INSTANTIATE_TEST_SUITE_P(
    Shapes, Areas,
    testing::Values(
        AreaCase{"box", make_box<2>({1, 2}, {4, 4}), 6.0, 10.0},
        AreaCase{"disc", make_disc({5, -3}, 2.0), 4.0 * pi, 4.0 * pi},
        AreaCase{"l_shape", l_shape(), 3.0, 8.0},
        AreaCase{"clockwise", make_polygon({{0, 0}, {0, 1}, {1, 0}}), 0.5, 2.0 + std::sqrt(2.0)},
        AreaCase{"hole_inside", make_difference(square(0, 0, 4), {make_disc({2, 2}, 1.0)}),
                 16.0 - pi, 16.0 + 2.0 * pi},
        AreaCase{"quarter_hole", make_difference(square(0, 0, 4), {make_disc({0, 0}, 1.0)}),
                 16.0 - pi / 4.0, 14.0 + pi / 2.0},
        AreaCase{"half_hole", make_difference(square(0, 0, 4), {make_disc({2, 0}, 1.0)}),
                 16.0 - pi / 2.0, 14.0 + pi},
        AreaCase{"bitten_edge", make_difference(square(0, 0, 4), {make_disc({2, -0.5}, 1.0)}),
                 16.0 - cap(1.0, 0.5), 16.0 - std::sqrt(3.0) + 2.0 * std::acos(0.5)},
        AreaCase{"ring", make_difference(make_disc({1, 1}, 3.0), {make_disc({1, 1}, 2.0)}),
                 5.0 * pi, 10.0 * pi},
        AreaCase{"lens_cut", make_difference(make_disc({0, 0}, 1.0), {make_disc({1, 0}, 1.0)}),
                 pi - 2.0 * cap(1.0, 0.5), 2.0 * pi},
        AreaCase{"corner_box", make_difference(square(0, 0, 2), {square(1, 1, 1)}), 3.0, 8.0},
        AreaCase{"overlapping_holes",
                 make_difference(square(0, 0, 4), {square(1, 1, 1), square(1.5, 1, 1)}), 14.5,
                 16.0 + 5.0},
        AreaCase{"holes_side_by_side",
                 make_difference(square(0, 0, 4), {square(1, 1, 1), square(2, 1, 1)}), 14.0,
                 16.0 + 6.0},
        AreaCase{"the_same_hole_twice",
                 make_difference(square(0, 0, 4), {make_disc({2, 2}, 1.0), make_disc({2, 2}, 1.0)}),
                 16.0 - pi, 16.0 + 2.0 * pi},
        AreaCase{"hole_that_touches_an_edge",
                 make_difference(square(0, 0, 4), {make_disc({2, 1}, 1.0)}), 16.0 - pi,
                 16.0 + 2.0 * pi},
        AreaCase{"island_in_the_hole",
                 make_difference(square(0, 0, 4), {make_difference(make_disc({2, 2}, 1.0),
                                                                   {make_disc({2, 2}, 0.5)})}),
                 16.0 - 0.75 * pi, 16.0 + 3.0 * pi}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Region, IntervalHasALengthTwoEndsAndAnInside) {
  const Shape<1> bar = make_interval(1.0, 3.0);
  EXPECT_EQ(area(bar), 2.0);
  EXPECT_EQ(boundary_measure(bar), 2.0);
  EXPECT_TRUE(contains(bar, Vector<1>(1.0)));
  EXPECT_TRUE(contains(bar, Vector<1>(3.0)));
  EXPECT_FALSE(contains(bar, Vector<1>(3.0 + 1e-8)));
  EXPECT_EQ(closest_boundary_point(bar, Vector<1>(2.5))(0), 3.0);
  EXPECT_EQ(signed_distance(bar, Vector<1>(1.25)), 0.25);
  EXPECT_EQ(signed_distance(bar, Vector<1>(-1.0)), -2.0);
}

TEST(Region, BoundingBoxes) {
  const Box<2> disc = bounding_box(make_disc({1, 2}, 0.5));
  EXPECT_EQ(disc.lower, Vector<2>(0.5, 1.5));
  EXPECT_EQ(disc.upper, Vector<2>(1.5, 2.5));
  const Box<2> triangle = bounding_box(make_polygon({{0, 1}, {3, -1}, {1, 2}}));
  EXPECT_EQ(triangle.lower, Vector<2>(0, -1));
  EXPECT_EQ(triangle.upper, Vector<2>(3, 2));
  // A hole does not shrink the lattice of its base.
  const Box<2> cut =
      bounding_box(make_difference(square(0, 0, 2), {make_box<2>({-1, -1}, {3, 1})}));
  EXPECT_EQ(cut.lower, Vector<2>(0, 0));
}

TEST(Region, BoundaryPointsBelongToTheShape) {
  const Shape<2> plate = make_difference(square(0, 0, 4), {make_disc({2, 2}, 1.0)});
  for (const Vector<2>& x : {Vector<2>(0, 0), Vector<2>(4, 2), Vector<2>(3, 2),
                             Vector<2>(2 + std::cos(1.0), 2 + std::sin(1.0))})
    EXPECT_TRUE(contains(plate, x)) << x.transpose();
  for (const Vector<2>& x : {Vector<2>(2, 2), Vector<2>(2.999999, 2), Vector<2>(4.000001, 2)})
    EXPECT_FALSE(contains(plate, x)) << x.transpose();
}

TEST(Region, ToleranceGrowsWithTheShape) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    const Shape<2> box = square(0, 0, size);
    EXPECT_TRUE(contains(box, Vector<2>(size * (1 + 1e-12), 0)));
    EXPECT_FALSE(contains(box, Vector<2>(size * (1 + 1e-8), 0)));
  }
}

TEST(Region, ConcavePolygonKnowsItsInside) {
  EXPECT_TRUE(contains(l_shape(), Vector<2>(0.5, 1.5)));
  EXPECT_TRUE(contains(l_shape(), Vector<2>(1.0, 1.0)));
  EXPECT_FALSE(contains(l_shape(), Vector<2>(1.5, 1.5)));
  EXPECT_FALSE(contains(l_shape(), Vector<2>(-0.5, 1.0)));  // level with two corners
  EXPECT_DOUBLE_EQ(depth(l_shape(), Vector<2>(1.5, 1.5)), -0.5);
  EXPECT_DOUBLE_EQ(depth(l_shape(), Vector<2>(0.25, 1.0)), 0.25);
}

TEST(Region, ClosestBoundaryPoints) {
  const Shape<2> plate = make_difference(square(0, 0, 4), {make_disc({0, 0}, 1.0)});
  EXPECT_NEAR((closest_boundary_point(plate, Vector<2>(0.9, 1.2)) - Vector<2>(0.6, 0.8)).norm(), 0,
              1e-15);
  EXPECT_NEAR((closest_boundary_point(plate, Vector<2>(5, 2)) - Vector<2>(4, 2)).norm(), 0, 1e-15);
  // In the cut corner the edges of the box are no boundary any more: the arc or its ends are.
  EXPECT_NEAR((closest_boundary_point(plate, Vector<2>(0.3, 0.4)) - Vector<2>(0.6, 0.8)).norm(), 0,
              1e-15);
  EXPECT_NEAR((closest_boundary_point(plate, Vector<2>(-1, 0.9)) - Vector<2>(0, 1)).norm(), 0,
              1e-15);
  EXPECT_NEAR(signed_distance(plate, Vector<2>(0.3, 0.4)), -0.5, 1e-15);
  EXPECT_NEAR(signed_distance(plate, Vector<2>(0.9, 1.2)), 0.5, 1e-15);
}

TEST(Region, DepthNeverExceedsTheDistance) {
  const Shape<2> shape = make_difference(l_shape(), {make_disc({1, 1}, 0.5)});
  for (double x = -0.5; x < 2.5; x += 0.17)
    for (double y = -0.5; y < 2.5; y += 0.19) {
      const Vector<2> point(x, y);
      const double distance = signed_distance(shape, point);
      EXPECT_LE(std::abs(depth(shape, point)), std::abs(distance) + 1e-14) << point.transpose();
    }
}

TEST(Region, BaseAndHolesOfNestedDifferences) {
  const Shape<2> inner = make_difference(square(0, 0, 4), {square(1, 1, 1)});
  const Shape<2> outer = make_difference(inner, {square(2, 2, 1)});
  EXPECT_TRUE(std::holds_alternative<Box<2>>(base_of(outer).form));
  const auto holes = holes_of(outer);
  ASSERT_EQ(holes.size(), 2u);
  EXPECT_EQ(std::get<Box<2>>(holes[0].form).lower, Vector<2>(1, 1));
  EXPECT_TRUE(holes_of(l_shape()).empty());
}

}  // namespace
}  // namespace tlsph

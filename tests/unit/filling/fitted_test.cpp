#include "tlsph/filling/fitted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "boundary_distance.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/points.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

Shape<2> quarter_sheet() {
  return make_difference(make_box<2>({0, 0}, {1, 1}), {make_disc({0, 0}, 0.4)});
}

struct FitCase {
  const char* name;
  Shape<2> shape;
};

class Fitted : public testing::TestWithParam<FitCase> {
 protected:
  static Particles<2> at(double spacing) {
    return fitted(make_lattice(GetParam().shape, spacing), GetParam().shape);
  }
};

TEST_P(Fitted, PutsEveryBoundaryNodeOnTheBoundary) {
  const auto body = at(0.05);
  const Patch<2>* boundary = body.find("boundary");
  const std::set<int> outer(boundary->nodes.begin(), boundary->nodes.end());
  for (int q = 0; q < static_cast<int>(body.size()); ++q) {
    const double distance = signed_distance(GetParam().shape, Vector<2>(body.X.row(q).transpose()));
    if (outer.contains(q))
      EXPECT_NEAR(distance, 0.0, 1e-12) << body.X.row(q);
    else
      EXPECT_GT(distance, 0.25 * 0.05) << body.X.row(q);
  }
}

TEST_P(Fitted, KeepsCellsConvex) {
  for (const double spacing : {0.1, 0.05, 0.025}) {
    const auto body = at(spacing);
    for (const auto& cell : body.cells)
      EXPECT_GT(least_jacobian<2>(body.X, cell), 0.1 * body.spacings.prod());
  }
}

TEST_P(Fitted, AreaErrsByTheSegmentsBetweenChordAndArcOnly) {
  // Chords of length ≤ 2 Δ cut segments of area ≤ (2 Δ)³/(12 R) each: O(Δ²) in all. Straight-edged
  // shapes are met exactly.
  const double exact = area(GetParam().shape);
  const double length = boundary_measure(GetParam().shape);
  for (const double spacing : {0.1, 0.05, 0.025}) {
    const auto body = at(spacing);
    EXPECT_NEAR(body.V.sum(), exact, 0.4 * length * spacing * spacing + 1e-13) << spacing;
    EXPECT_NEAR(cell_points(body).V.sum(), body.V.sum(), 1e-12);
  }
}

TEST_P(Fitted, KeepsTheMomentsOfTheBoundary) {
  const auto body = at(0.05);
  const Tensor<2> first = body.B.transpose() * body.X;
  EXPECT_NEAR(body.B.colwise().sum().norm(), 0.0, 1e-13);
  EXPECT_NEAR((first - body.V.sum() * Tensor<2>::Identity()).norm(), 0.0, 1e-12);
  EXPECT_GT(body.V.minCoeff(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Fitted,
    testing::Values(
        FitCase{"disc", make_disc({0, 0}, 1.0)}, FitCase{"quarter", quarter_sheet()},
        FitCase{"hole",
                make_difference(make_box<2>({0, 0}, {2, 2}), {make_disc({1.03, 0.98}, 0.5)})},
        FitCase{"ring", make_difference(make_disc({0, 0}, 1.0), {make_disc({0, 0}, 0.5)})},
        FitCase{"triangle", make_polygon({{0, 0}, {2, 0}, {0.7, 1.6}})},
        FitCase{"bite", make_difference(make_box<2>({0, 0}, {2, 1}), {make_disc({1, -0.3}, 0.6)})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FittedPatches, OfAQuarterSheetMeetOnTheSymmetryLines) {
  const auto sheet = fitted(make_lattice(quarter_sheet(), 0.05), quarter_sheet());
  double lowest = 1.0;
  for (const int node : sheet.find("left")->nodes) {
    EXPECT_EQ(sheet.X(node, 0), 0.0);
    lowest = std::min(lowest, sheet.X(node, 1));
  }
  EXPECT_NEAR(lowest, 0.4, 1e-12);
  for (const int node : sheet.find("hole")->nodes)
    EXPECT_NEAR(sheet.X.row(node).norm(), 0.4, 1e-12);
  EXPECT_EQ(sheet.find("hole")->faces.size() + sheet.find("outer")->faces.size(),
            sheet.find("boundary")->faces.size());
  Vector<2> hole = Vector<2>::Zero();
  for (const auto& face : sheet.find("hole")->faces) hole += face.area;
  EXPECT_NEAR((hole - Vector<2>(-0.4, -0.4)).norm(), 0.0, 1e-12);
}

TEST(FittedNodes, FarFromTheCurveStayOnTheLattice) {
  const auto sheet = fitted(make_lattice(quarter_sheet(), 0.05), quarter_sheet());
  int regular = 0;
  for (Index q = 0; q < sheet.size(); ++q) {
    if (sheet.X.row(q).norm() < 0.4 + 6.5 * 0.05) continue;
    ++regular;
    for (int a = 0; a < 2; ++a)
      EXPECT_NEAR(std::remainder(sheet.X(q, a), 0.05), 0.0, 1e-12) << sheet.X.row(q);
  }
  EXPECT_GT(regular, 150);
}

TEST(FittedNodes, TakeTheCornersOfAPolygon) {
  const std::vector<Vector<2>> corners = {{0, 0}, {2, 0}, {0.7, 1.6}};
  const Shape<2> triangle = make_polygon(corners);
  const auto body = fitted(make_lattice(triangle, 0.1), triangle);
  for (const auto& corner : corners)
    EXPECT_NEAR((body.X.rowwise() - corner.transpose()).rowwise().norm().minCoeff(), 0.0, 1e-12);
}

TEST(FittedNodes, OfALatticeAlignedShapeAreUntouched) {
  const Shape<2> body = make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const auto lattice = make_lattice(body, 0.25);
  EXPECT_EQ(fitted(lattice, body).X, lattice.X);
}

class Refusals : public testing::TestWithParam<FitCase> {};

TEST_P(Refusals, NamePlaceAndRemedy) {
  const auto lattice = make_lattice(GetParam().shape, 0.25);
  EXPECT_THAT(
      refusal([&] {
        (void)fitted(lattice, GetParam().shape, {"a.toml", 2, 1, "body"});
      }),
      HasSubstr("a.toml:2:1: body: spacing 0.25 is too coarse to follow the boundary near"));
}

/// The widths that the parts and gaps have, from wide enough for two cells to far too narrow.
std::vector<FitCase> narrow(double width) {
  const double half = 0.5 * width;
  return {
      {"hole_near_an_edge",
       make_difference(make_box<2>({0, 0}, {4, 4}), {make_disc({1, 2}, 1 - width)})},
      {"two_holes_near_each_other",
       make_difference(make_box<2>({0, 0}, {4, 4}),
                       {make_disc({1.2, 2}, 0.8 - half), make_disc({2.8, 2}, 0.8 - half)})},
      {"thin_ring",
       make_difference(make_disc({0, 0}, 1.0), {make_disc({0.15 - half, 0}, 0.85 - half)})},
      {"sliver", make_difference(make_box<2>({0, 0}, {4, 4}),
                                 {make_polygon({{width, -1}, {1.3, -1}, {1.3, 5}, {width, 5}})})},
      {"fin", make_polygon({{0, 0},
                            {2, 0.1},
                            {2, 2 - half},
                            {4, 2.05 - half},
                            {4, 2.05 + half},
                            {2, 2 + half},
                            {2, 4},
                            {0, 4}})}};
}

INSTANTIATE_TEST_SUITE_P(TooNarrow, Refusals, testing::ValuesIn(narrow(0.004)),
                         [](const auto& test) { return std::string(test.param.name); });

class Narrow : public testing::TestWithParam<FitCase> {};

TEST_P(Narrow, PartsAreFilled) {
  const Shape<2>& shape = GetParam().shape;
  const auto body = fitted(make_lattice(shape, 0.25), shape);
  EXPECT_NEAR(body.V.sum(), area(shape), 0.4 * boundary_measure(shape) * 0.25 * 0.25);
  for (const auto& cell : body.cells)
    EXPECT_GT(least_jacobian<2>(body.X, cell), 0.099 * 0.25 * 0.25);
  for (const int node : body.find("boundary")->nodes)
    EXPECT_NEAR(signed_distance(shape, Vector<2>(body.X.row(node).transpose())), 0.0, 1e-9);
  const Tensor<2> first = body.B.transpose() * body.X;
  EXPECT_NEAR((first - body.V.sum() * Tensor<2>::Identity()).norm(), 0.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(OneSpacing, Narrow, testing::ValuesIn(narrow(0.25)),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FittedNodes, RefusalNamesTheHexagonalLayout) {
  const Shape<2> sheet = narrow(0.004).front().shape;
  EXPECT_THAT(refusal([&] { (void)fitted(sheet, 0.25); }),
              HasSubstr("body.layout = \"hexagonal\""));
}

/// An edge along the lattice meets a slanted one at 135°.
TEST(FittedNodes, FollowAChamferAtEverySpacing) {
  const Shape<2> plate = make_polygon({{0, 0}, {2, 0}, {2, 0.5}, {1.5, 1}, {0, 1}});
  for (const double spacing : {0.1, 0.05, 0.025, 0.0125, 0.00625}) {
    const auto body = fitted(plate, spacing);
    EXPECT_NEAR(body.V.sum(), 1.875, 1e-12) << spacing;
    for (const auto& cell : body.cells)
      EXPECT_GT(least_jacobian<2>(body.X, cell), 0.25 * spacing * spacing) << spacing;
  }
}

/// The height is no whole number of spacings: lattice lines are stretched to it.
TEST(FittedNodes, NeedNoSpacingThatDividesAPolygon) {
  const Shape<2> quadrilateral = make_polygon({{0, 0}, {2, 0.3}, {2, 1.17}, {0, 0.83}});
  for (const double spacing : {0.25, 0.17, 0.1, 0.073})
    EXPECT_NEAR(fitted(quadrilateral, spacing).V.sum(), area(quadrilateral), 1e-12) << spacing;
  EXPECT_THAT(refusal([&] {
                (void)fitted(make_box<2>({0, 0}, {1, 0.83}), 0.25);
              }),
              HasSubstr("does not divide the body"));
}

TEST(FittedNodes, NeedALatticeWithCells) {
  const Shape<2> disc = make_disc({0, 0}, 1.0);
  const auto centred = make_lattice(disc, 0.1, NodePlacement::cell_centred);
  EXPECT_THAT(refusal([&] { (void)fitted(centred, disc); }), HasSubstr("nodes on the boundary"));
}

}  // namespace
}  // namespace tlsph

#include "tlsph/filling/lattice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tlsph/geometry/region.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> patch_names(const auto& particles) {
  std::vector<std::string> names;
  for (const auto& patch : particles.patches) names.push_back(patch.name);
  return names;
}

template <int D>
Vector<D> total_area(const Patch<D>& patch) {
  Vector<D> sum = Vector<D>::Zero();
  for (const auto& face : patch.faces) sum += face.area;
  return sum;
}

Shape<2> unit_square() {
  return make_box<2>({0, 0}, {1, 1});
}

TEST(Lattice, IntervalOfTwoCellsHasHalfVolumesAtItsEnds) {
  const auto bar = make_lattice(make_interval(1.0, 3.0), 1.0);
  ASSERT_EQ(bar.size(), 3);
  EXPECT_EQ(bar.X, (VectorField<1>(3, 1) << 1, 2, 3).finished());
  EXPECT_EQ(bar.V, (ScalarField(3) << 0.5, 1, 0.5).finished());
  EXPECT_EQ(bar.B, (VectorField<1>(3, 1) << -1, 0, 1).finished());
  EXPECT_THAT(bar.cells, ElementsAre(Cell<1>{0, 1}, Cell<1>{1, 2}));
  EXPECT_THAT(patch_names(bar), ElementsAre("left", "right", "outer", "boundary"));
  EXPECT_THAT(bar.find("left")->nodes, ElementsAre(0));
  EXPECT_THAT(bar.find("right")->nodes, ElementsAre(2));
  EXPECT_EQ(bar.find("right")->faces.at(0).area(0), 1.0);
  EXPECT_EQ(bar.spacing, 1.0);
}

TEST(Lattice, CellCentredIntervalHasWholeVolumesAndNoCells) {
  const auto bar = make_lattice(make_interval(0.0, 2.0), 1.0, NodePlacement::cell_centred);
  ASSERT_EQ(bar.size(), 2);
  EXPECT_EQ(bar.X, (VectorField<1>(2, 1) << 0.5, 1.5).finished());
  EXPECT_EQ(bar.V, (ScalarField(2) << 1, 1).finished());
  EXPECT_EQ(bar.B, (VectorField<1>(2, 1) << -1, 1).finished());
  EXPECT_TRUE(bar.cells.empty());
}

TEST(Lattice, OneCellHasFourQuarters) {
  const auto cell = make_lattice(unit_square(), 1.0);
  ASSERT_EQ(cell.size(), 4);
  EXPECT_EQ(cell.X, (VectorField<2>(4, 2) << 0, 0, 0, 1, 1, 0, 1, 1).finished());
  EXPECT_EQ(cell.V, ScalarField::Constant(4, 0.25));
  EXPECT_EQ(cell.B,
            (VectorField<2>(4, 2) << -0.5, -0.5, -0.5, 0.5, 0.5, -0.5, 0.5, 0.5).finished());
  EXPECT_THAT(cell.cells, ElementsAre(Cell<2>{0, 2, 3, 1}));  // counter-clockwise
}

TEST(Lattice, CellCentredSquareOfOneCellGathersAllFourFaces) {
  const auto cell = make_lattice(unit_square(), 1.0, NodePlacement::cell_centred);
  ASSERT_EQ(cell.size(), 1);
  EXPECT_EQ(cell.V(0), 1.0);
  EXPECT_EQ(cell.find("boundary")->faces.size(), 4u);
  EXPECT_EQ(cell.find("top")->faces.at(0).nodes, (std::array<int, 2>{0, 0}));
  EXPECT_EQ(cell.B.row(0).norm(), 0.0);
}

TEST(Lattice, NodesRunAlongTheLongerSideAndAlongYOfEqualOnes) {
  EXPECT_EQ((LatticeFrame<2>{{0, 0}, {1, 1}, {3, 3}}.index({1, 2})), 1 * 3 + 2);
  EXPECT_EQ((LatticeFrame<2>{{0, 0}, {1, 1}, {3, 4}}.index({1, 2})), 1 * 4 + 2);
  const auto plate = make_lattice(make_box<2>({0, 0}, {3, 2}), 1.0);
  ASSERT_TRUE(plate.frame.has_value());
  EXPECT_EQ(plate.frame->counts, (std::array<int, 2>{4, 3}));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) {
      const int row = plate.frame->index({i, j});
      EXPECT_EQ(row, i + 4 * j);
      EXPECT_EQ(plate.frame->coordinates(row), (std::array<int, 2>{i, j}));
      EXPECT_EQ(plate.X(row, 0), i);
      EXPECT_EQ(plate.X(row, 1), j);
    }
  EXPECT_EQ(plate.V(plate.frame->index({1, 1})), 1.0);
  EXPECT_EQ(plate.V(plate.frame->index({0, 1})), 0.5);
  EXPECT_EQ(plate.V(plate.frame->index({0, 0})), 0.25);
}

TEST(Lattice, FacesKeepTheBodyOnTheirLeft) {
  const auto plate = make_lattice(make_box<2>({0, 0}, {2, 3}), 1.0);
  for (const auto& face : plate.find("boundary")->faces) {
    const Vector<2> edge = (plate.X.row(face.nodes[1]) - plate.X.row(face.nodes[0])).transpose();
    EXPECT_NEAR((face.area - Vector<2>(edge.y(), -edge.x())).norm(), 0.0, 1e-15);
  }
  EXPECT_EQ(total_area(*plate.find("left")), Vector<2>(-3, 0));
  EXPECT_EQ(total_area(*plate.find("right")), Vector<2>(3, 0));
  EXPECT_EQ(total_area(*plate.find("bottom")), Vector<2>(0, -2));
  EXPECT_EQ(total_area(*plate.find("top")), Vector<2>(0, 2));
  EXPECT_THAT(plate.find("left")->nodes, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(plate.find("bottom")->nodes, ElementsAre(0, 4, 8));
}

TEST(Lattice, CornerCutOutLeavesAThreeQuarterNode) {
  // An L of three unit cells; node (1, 1) is the re-entrant corner.
  const auto body = make_lattice(
      make_difference(make_box<2>({0, 0}, {2, 2}), {make_box<2>({1, 1}, {2, 2})}), 1.0);
  ASSERT_EQ(body.size(), 8);  // node (2, 2) is gone
  EXPECT_EQ(body.X.row(4), Eigen::RowVector2d(1, 1));
  EXPECT_EQ(body.V(4), 0.75);
  EXPECT_EQ(body.B.row(4), Eigen::RowVector2d(0.5, 0.5));
  EXPECT_THAT(patch_names(body),
              ElementsAre("left", "right", "bottom", "top", "hole", "hole1", "outer", "boundary"));
  EXPECT_EQ(body.find("hole")->faces.size(), 2u);
  EXPECT_EQ(body.find("right")->faces.size(), 1u);
  EXPECT_EQ(body.find("outer")->faces.size(), 6u);
  EXPECT_FALSE(body.frame.has_value());
}

TEST(Lattice, TwoHolesHaveNamesOfTheirOwn) {
  const auto body =
      make_lattice(make_difference(make_box<2>({0, 0}, {5, 3}),
                                   {make_box<2>({1, 1}, {2, 2}), make_box<2>({3, 1}, {4, 2})}),
                   1.0);
  EXPECT_EQ(body.find("hole")->faces.size(), 8u);
  EXPECT_EQ(body.find("hole1")->faces.size(), 4u);
  EXPECT_THAT(body.find("hole2")->nodes, ElementsAre(9, 10, 15, 16));
  EXPECT_EQ(total_area(*body.find("hole1")).norm(), 0.0);
}

TEST(Lattice, QuarterHoleLeavesTheSymmetryEdgesTheirNames) {
  const auto sheet =
      make_lattice(make_difference(make_box<2>({0, 0}, {10, 10}), {make_disc({0, 0}, 5.0)}), 1.0);
  for (const char* edge : {"left", "bottom"}) {
    ASSERT_NE(sheet.find(edge), nullptr);
    EXPECT_EQ(sheet.find(edge)->faces.size(), 5u) << edge;
  }
  // The stairs project onto the radius in both directions.
  EXPECT_EQ(total_area(*sheet.find("hole")), Vector<2>(-5, -5));
}

TEST(Lattice, CurvedBodiesKeepOnlyTheEdgesTheyTouch) {
  const auto triangle = make_lattice(make_polygon({{0, 0}, {8, 0}, {8, 8}}), 1.0);
  EXPECT_EQ(triangle.find("bottom")->faces.size(), 8u);
  EXPECT_EQ(triangle.find("right")->faces.size(), 8u);
  // Cells cut in half have their centre on the boundary and belong to the closed set.
  EXPECT_EQ(triangle.cells.size(), 36u);
  EXPECT_EQ(triangle.find("left")->faces.size(), 1u);
  EXPECT_EQ(triangle.find("outer")->faces.size(), triangle.find("boundary")->faces.size());
}

class Moments : public testing::TestWithParam<Shape<2>> {};

TEST_P(Moments, OfBoundaryAreasAreThoseOfTheCells) {
  const auto body = make_lattice(GetParam(), 0.125);
  const double size = body.V.sum();
  const Vector<2> sum = body.B.colwise().sum().transpose();
  const Tensor<2> first = body.B.transpose() * body.X;
  EXPECT_NEAR(size, static_cast<double>(body.cells.size()) * body.spacings.prod(), 1e-13 * size);
  EXPECT_NEAR(sum.norm(), 0.0, 1e-13 * size);
  EXPECT_NEAR((first - size * Tensor<2>::Identity()).norm(), 0.0, 1e-13 * size);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Moments,
    testing::Values(make_box<2>({-1, 2}, {1, 3.5}), make_disc({3, 1}, 1.0),
                    make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}),
                    make_difference(make_box<2>({0, 0}, {2, 2}),
                                    {make_disc({0, 0}, 0.7), make_disc({1.3, 1.2}, 0.4)})));

TEST(Lattice, VolumeOfABoxIsItsArea) {
  const auto box = make_lattice(make_box<2>({0.1, -0.3}, {0.4, 0.4}), 0.01);
  EXPECT_NEAR(box.V.sum(), 0.21, 1e-14);
  EXPECT_EQ(box.X.row(box.size() - 1), Eigen::RowVector2d(0.4, 0.4));
}

TEST(Lattice, VolumeOfADiscConvergesToItsArea) {
  // The stairs err by at most a cell along the perimeter; the sum converges faster than that.
  for (const double spacing : {0.1, 0.02, 0.005}) {
    const auto disc = make_lattice(make_disc({0, 0}, 1.0), spacing);
    EXPECT_NEAR(disc.V.sum(), std::numbers::pi, 0.3 * spacing) << spacing;
  }
}

TEST(Lattice, SpacingIsTakenToTheNearestDivision) {
  const auto plate = make_lattice(make_box<2>({0, 0}, {1.0, 0.995}), 0.1);
  EXPECT_DOUBLE_EQ(plate.spacings(0), 0.1);
  EXPECT_DOUBLE_EQ(plate.spacings(1), 0.0995);
  EXPECT_DOUBLE_EQ(plate.spacing, std::sqrt(0.1 * 0.0995));
  EXPECT_NEAR(plate.V.sum(), 0.995, 1e-14);
}

TEST(Lattice, NamesTheNearestSpacingThatFits) {
  const std::string text = refusal([] {
    (void)make_lattice(make_interval(0, 0.15), 0.04, {}, {"bar.toml", 4, 2, "body.spacing"});
  });
  EXPECT_THAT(text, HasSubstr("bar.toml:4:2: body.spacing: spacing 0.04"));
  EXPECT_THAT(text, HasSubstr("nearest spacing that fits is 0.0375"));
  EXPECT_EQ(make_lattice(make_interval(0, 0.15), 0.0375).size(), 5);
}

TEST(Lattice, NearestSpacingFitsBothDirections) {
  const Shape<2> plate = make_box<2>({0, 0}, {1.0, 0.3});
  EXPECT_THAT(refusal([&] { (void)make_lattice(plate, 0.25); }),
              HasSubstr("along y (length 0.3) the nearest division is 1 x 0.3, a change of 20 % "
                        "where 1 % is allowed; "
                        "the nearest spacing that fits is 0.1"));
}

TEST(Lattice, RefusesWhatCannotBeBuilt) {
  EXPECT_THAT(refusal([] { (void)make_lattice(unit_square(), 0.0); }), HasSubstr("greater than 0"));
  EXPECT_THAT(refusal([] { (void)make_lattice(unit_square(), -1.0); }),
              HasSubstr("greater than 0"));
  EXPECT_THAT(refusal([] { (void)make_lattice(unit_square(), std::nan("")); }),
              HasSubstr("greater than 0"));
  EXPECT_THAT(refusal([] { (void)make_lattice(unit_square(), 1e-12); }),
              HasSubstr("more than the 2147483647"));
  EXPECT_THAT(refusal([] { (void)make_lattice(make_interval(1, 1), 0.1); }), HasSubstr("empty"));
  EXPECT_THAT(refusal([] {
                (void)make_lattice(make_polygon({{0, 0}, {2, 0}, {2, 2}, {1.8, 0.2}}), 2.0);
              }),
              HasSubstr("too coarse for it"));
  EXPECT_THAT(
      refusal([] {
        (void)make_lattice(make_difference(unit_square(), {make_disc({0.5, 0.5}, 0.05)}), 0.25);
      }),
      HasSubstr("hole 1 is lost between the cells"));
}

TEST(SizeEstimate, IsExactForBoxesAndNeverOverflows) {
  EXPECT_EQ(lattice_size_estimate(make_interval(0, 0.15), 2.5e-4), 601.0);
  EXPECT_EQ(lattice_size_estimate(make_box<2>({0, 0}, {3, 2}), 1.0), 12.0);
  EXPECT_EQ(lattice_size_estimate(make_box<2>({0, 0}, {3, 2}), 1.0, NodePlacement::cell_centred),
            6.0);
  EXPECT_NEAR(lattice_size_estimate(unit_square(), 1e-12), 1e24, 1e13);
  EXPECT_THROW((void)lattice_size_estimate(unit_square(), 0.0), InputError);
}

TEST(SizeEstimate, IsWithinAFewPercentForCurvedBodies) {
  const Shape<2> sheet = make_difference(make_disc({0, 0}, 1.0), {make_disc({0.2, 0}, 0.4)});
  const auto built = static_cast<double>(make_lattice(sheet, 0.02).size());
  EXPECT_NEAR(lattice_size_estimate(sheet, 0.02) / built, 1.0, 0.03);
}

TEST(NamedBox, TakesNodesAndTheFacesBetweenThem) {
  const auto plate =
      with_named_box<2>(make_lattice(make_box<2>({0, 0}, {2, 2}), 1.0), "foot", {0, 0}, {1, 0});
  const Patch<2>* foot = plate.find("foot");
  ASSERT_NE(foot, nullptr);
  EXPECT_THAT(foot->nodes, ElementsAre(0, 3));
  ASSERT_EQ(foot->faces.size(), 1u);
  EXPECT_EQ(foot->faces[0].area, Vector<2>(0, -1));
}

TEST(NamedBox, OfInnerNodesHasNoFaces) {
  const auto plate = with_named_box<2>(make_lattice(make_box<2>({0, 0}, {2, 2}), 1.0), "middle",
                                       {0.5, 0.5}, {1.5, 1.5});
  EXPECT_THAT(plate.find("middle")->nodes, ElementsAre(4));
  EXPECT_TRUE(plate.find("middle")->faces.empty());
}

TEST(NamedBox, RefusesEmptyUpsideDownAndTakenNames) {
  const auto plate = make_lattice(make_box<2>({0, 0}, {2, 2}), 1.0);
  EXPECT_THAT(refusal([&] {
                (void)with_named_box<2>(plate, "gap", {0.2, 0.2}, {0.8, 0.8});
              }),
              HasSubstr("tag \"gap\" holds no particles"));
  EXPECT_THAT(refusal([&] {
                (void)with_named_box<2>(plate, "gap", {1, 0}, {0, 1});
              }),
              HasSubstr("upside down"));
  EXPECT_THAT(refusal([&] {
                (void)with_named_box<2>(plate, "left", {0, 0}, {1, 1});
              }),
              HasSubstr("already names"));
}

}  // namespace
}  // namespace tlsph

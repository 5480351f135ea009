// Every shape and every tag a scene can draw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "scenes.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;

TEST(ShapeKey, Interval) {
  const Scene scene = bar_with({"body.shape.interval=[-1, 3]"});

  EXPECT_EQ(area(std::get<Shape<1>>(scene.body.shape)), 4.0);
}

struct SheetShape {
  std::string toml;
  double area;
};

void PrintTo(const SheetShape& shape, std::ostream* stream) {
  *stream << shape.toml;
}

class SheetShapes : public testing::TestWithParam<SheetShape> {};

TEST_P(SheetShapes, HaveTheirArea) {
  const Scene scene = sheet_with({"body.shape=" + GetParam().toml});

  EXPECT_NEAR(area(std::get<Shape<2>>(scene.body.shape)), GetParam().area, 1e-12);
}

constexpr double pi = std::numbers::pi;
INSTANTIATE_TEST_SUITE_P(
    All, SheetShapes,
    testing::Values(
        SheetShape{"{box = [[0, 0], [2, 3]]}", 6.0},
        SheetShape{"{disc = {centre = [1, 1], radius = 2}}", 4 * pi},
        SheetShape{"{polygon = [[0, 0], [2, 0], [0, 2]]}", 2.0},
        SheetShape{
            "{difference = [{box = [[0, 0], [4, 4]]}, {disc = {centre = [2, 2], radius = 1}}]}",
            16 - pi},
        SheetShape{"{difference = [{box = [[0, 0], [4, 4]]}, {box = [[1, 1], [2, 2]]}, "
                   "{polygon = [[3, 3], [4, 3], [4, 4]]}]}",
                   14.5},
        SheetShape{"{difference = [{difference = [{disc = {centre = [0, 0], radius = 2}}, "
                   "{disc = {centre = [0, 0], radius = 1}}]}, {box = [[-3, -3], [3, 0]]}]}",
                   1.5 * pi}));

TEST(LayoutKey, IsSquareUnlessSaid) {
  EXPECT_EQ(sheet_with({}).body.layout, Layout::square);
  EXPECT_FALSE(sheet_with({}).body.is_cloud());
  const Scene scene = sheet_with({"body.layout=hexagonal"});
  EXPECT_EQ(scene.body.layout, Layout::hexagonal);
  EXPECT_TRUE(scene.body.is_cloud());
  EXPECT_TRUE(scene.body.fit);
}

TEST(LayoutKey, HexagonalTakesTheHourglassStabiliserAway) {
  EXPECT_EQ(sheet_with({"formulation=stress-point"}).stabiliser.kind, StabiliserKind::cell);
  EXPECT_EQ(sheet_with({"formulation=stress-point", "body.layout=hexagonal"}).stabiliser.kind,
            StabiliserKind::none);
}

TEST(CloudKey, NamesAFileAndLeavesTheSpacingToIt) {
  const Scene scene = sheet_with({"body={shape={box=[[0,0],[1,1]]},cloud=\"p.csv\"}"});
  EXPECT_EQ(scene.body.cloud, "p.csv");
  EXPECT_EQ(scene.body.spacing, 0.0);
  EXPECT_TRUE(scene.body.is_cloud());
}

TEST(FitKey, IsOnWhereNodesCanFollowTheBoundary) {
  EXPECT_TRUE(sheet_with({}).body.fit);
  EXPECT_TRUE(sheet_with({"formulation=variational"}).body.fit);
  EXPECT_FALSE(sheet_with({"body.fit=false"}).body.fit);
  EXPECT_FALSE(sheet_with({"formulation=mirror"}).body.fit);
  EXPECT_FALSE(sheet_with({"formulation=variational", "body.placement=cell-centred"}).body.fit);
  EXPECT_FALSE(bar_with({}).body.fit);
}

TEST(TagKey, NamesABox) {
  const Scene scene = sheet_with({"body.tags=[{name=\"spot\", box=[[0.5, 0.5], [1, 1]]}]"});

  ASSERT_EQ(scene.body.tags.size(), 1U);
  EXPECT_EQ(scene.body.tags[0].name, "spot");
  EXPECT_THAT(scene.body.tags[0].lower, ElementsAre(0.5, 0.5));
  EXPECT_THAT(scene.body.tags[0].upper, ElementsAre(1, 1));
}

TEST(TagKey, IsAnIntervalIn1D) {
  for (const std::string box : {"[0.2, 0.4]", "[[0.2], [0.4]]"}) {
    const Scene scene = bar_with({"body.tags=[{name=\"middle\", box=" + box + "}]"});

    EXPECT_THAT(scene.body.tags[0].lower, ElementsAre(0.2));
    EXPECT_THAT(scene.body.tags[0].upper, ElementsAre(0.4));
  }
}

TEST(ProbeKey, MayLieOnTheBoundaryOfAHole) {
  const std::string sheet =
      "body.shape={difference = [{box = [[0, 0], [4, 4]]}, {disc = {centre = [0, 0], radius = "
      "1}}]}";

  EXPECT_NO_THROW(static_cast<void>(sheet_with({sheet, "probe[0].at=[0, 1]"})));
  EXPECT_THROW(static_cast<void>(sheet_with({sheet, "probe[0].at=[0.5, 0.5]"})), InputError);
}

}  // namespace
}  // namespace tlsph

// Conditions, loads and every curve they can follow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

BoundaryScene left_of_sheet(const std::string& keys) {
  return sheet_with({"boundary[0]={where=\"left\", " + keys + "}"}).boundaries[0];
}

TEST(Fixed, HoldsAllOrSomeComponents) {
  EXPECT_THAT(left_of_sheet("fixed=true").fixed, ElementsAre(0, 1));
  EXPECT_THAT(left_of_sheet("fixed=\"y\"").fixed, ElementsAre(1));
  EXPECT_THAT(left_of_sheet("fixed=[\"y\", \"x\"]").fixed, ElementsAre(0, 1));
  EXPECT_THAT(left_of_sheet("fixed=false, symmetry=true").fixed, IsEmpty());
}

TEST(Fixed, HoldsTheOneComponentOfABar) {
  const Scene scene = bar_with({"boundary[0]={where=\"left\", fixed=true}"});

  EXPECT_THAT(scene.boundaries[0].fixed, ElementsAre(0));
}

TEST(Displacement, MovesTheComponentsItNames) {
  const auto boundary =
      left_of_sheet("displacement={y=0.5, x={curve=\"ramp\", amplitude=2, rise=3}}");

  ASSERT_EQ(boundary.motion.size(), 2U);
  EXPECT_EQ(boundary.motion[0].component, 1);
  EXPECT_EQ(std::get<ConstantCurve>(boundary.motion[0].curve).amplitude, 0.5);
  EXPECT_EQ(boundary.motion[1].component, 0);
  EXPECT_EQ(std::get<RampCurve>(boundary.motion[1].curve).rise, 3);
}

TEST(Traction, OfANumberIsNormal) {
  const auto boundary = left_of_sheet("traction=-5");

  EXPECT_EQ(std::get<ConstantCurve>(*boundary.normal_traction).amplitude, -5);
  EXPECT_THAT(boundary.traction, IsEmpty());
}

TEST(Traction, OfAListIsAVector) {
  const auto boundary = left_of_sheet("traction=[0, -5]");

  EXPECT_FALSE(boundary.normal_traction);
  ASSERT_EQ(boundary.traction.size(), 1U);
  EXPECT_EQ(boundary.traction[0].component, 1);
  EXPECT_EQ(std::get<ConstantCurve>(boundary.traction[0].curve).amplitude, -5);
}

TEST(Traction, OfACurveWithAListIsAVector) {
  const auto boundary =
      left_of_sheet("traction={curve=\"sine-squared\", amplitude=[3, 4], duration=2}");

  ASSERT_EQ(boundary.traction.size(), 2U);
  EXPECT_EQ(std::get<SineSquaredCurve>(boundary.traction[0].curve).amplitude, 3);
  EXPECT_EQ(std::get<SineSquaredCurve>(boundary.traction[1].curve).amplitude, 4);
  EXPECT_EQ(std::get<SineSquaredCurve>(boundary.traction[1].curve).duration, 2);
}

Curve curve(const std::string& keys) {
  return *left_of_sheet("traction={" + keys + "}").normal_traction;
}

TEST(CurveKey, Constant) {
  const auto read = std::get<ConstantCurve>(curve("curve=\"constant\", amplitude=2"));

  EXPECT_EQ(read.amplitude, 2);
}

TEST(CurveKey, Ramp) {
  const auto read = std::get<RampCurve>(curve("curve=\"ramp\", amplitude=2, rise=3"));

  EXPECT_EQ(read.amplitude, 2);
  EXPECT_EQ(read.rise, 3);
  EXPECT_FALSE(read.smooth);
}

TEST(CurveKey, SmoothRamp) {
  const auto read = std::get<RampCurve>(curve("curve=\"smooth-ramp\", amplitude=2, rise=3"));

  EXPECT_EQ(read.rise, 3);
  EXPECT_TRUE(read.smooth);
}

TEST(CurveKey, Pulse) {
  const auto read = std::get<PulseCurve>(curve("curve=\"pulse\", amplitude=2, rise=3, duration=4"));

  EXPECT_EQ(read.amplitude, 2);
  EXPECT_EQ(read.rise, 3);
  EXPECT_EQ(read.duration, 4);
}

TEST(CurveKey, SineSquared) {
  const auto read =
      std::get<SineSquaredCurve>(curve("curve=\"sine-squared\", amplitude=2, duration=4"));

  EXPECT_EQ(read.amplitude, 2);
  EXPECT_EQ(read.duration, 4);
}

TEST(CurveKey, TableIsScaledByItsAmplitude) {
  const auto plain = std::get<TableCurve>(curve("curve=\"table\", time=[0, 1], value=[2, 3]"));
  const auto scaled =
      std::get<TableCurve>(curve("curve=\"table\", time=[0, 1], value=[2, 3], amplitude=10"));

  EXPECT_THAT(plain.time, ElementsAre(0, 1));
  EXPECT_THAT(plain.values, ElementsAre(2, 3));
  EXPECT_THAT(scaled.values, ElementsAre(20, 30));
}

TEST(CurveKey, TableOfALoadIsLinearUnlessAskedOtherwise) {
  const std::string table = "curve=\"table\", time=[0, 1, 2], value=[0, 1, 0]";

  EXPECT_TRUE(std::get<TableCurve>(curve(table)).curvature.empty());
  EXPECT_THAT(std::get<TableCurve>(curve(table + ", interpolation=\"cubic\"")).curvature,
              ElementsAre(0, -3, 0));
}

TEST(CurveKey, TableOfAMotionIsCubicUnlessAskedOtherwise) {
  const auto motion = [](const std::string& rest) {
    const BoundaryScene boundary = left_of_sheet(
        "displacement={x={curve=\"table\", time=[0, 1, 2], value=[0, 1, 0]" + rest + "}}");
    return std::get<TableCurve>(boundary.motion.front().curve);
  };

  EXPECT_THAT(motion("").curvature, ElementsAre(0, -3, 0));
  EXPECT_TRUE(motion(", interpolation=\"linear\"").curvature.empty());
}

TEST(CurveKey, InterpolationBelongsToTablesOnly) {
  EXPECT_THROW((void)curve("curve=\"ramp\", amplitude=1, rise=1, interpolation=\"cubic\""),
               InputError);
}

// What belongs together on one patch is no contradiction.
TEST(Conditions, OfDifferentComponentsGoTogether) {
  EXPECT_NO_THROW(left_of_sheet("fixed=\"y\", traction=-5"));
  EXPECT_NO_THROW(left_of_sheet("fixed=\"x\", traction=[0, -5]"));
  EXPECT_NO_THROW(left_of_sheet("fixed=\"x\", displacement={y=0.1}"));
  EXPECT_NO_THROW(left_of_sheet("fixed=true, symmetry=true"));
}

TEST(Conditions, OfOnePatchMayStandInTwoEntries) {
  const Scene scene = sheet_with({"boundary[0]={where=\"left\", fixed=\"x\"}",
                                  "boundary[1]={where=\"left\", displacement={y=0.1}}"});

  EXPECT_EQ(scene.boundaries.size(), 2U);
}

TEST(Gravity, HasAComponentPerDimension) {
  EXPECT_THAT(sheet_with({"gravity=[0, -9.81]"}).body_force, ElementsAre(0, -9.81));
  EXPECT_THAT(bar_with({"gravity=[2]"}).body_force, ElementsAre(2));
}

}  // namespace
}  // namespace tlsph

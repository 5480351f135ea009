#include "tlsph/simulation/reduction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/scene/edit.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

const std::string head = "[material]\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n";

/// A strip between rollers, pulled to the right.
const std::string strip = head + R"([body]
shape = { box = [[0.0, 0.0], [1.0, 0.2]] }
spacing = 0.1
[[boundary]]
where = "left"
fixed = "x"
[[boundary]]
where = "bottom"
symmetry = true
[[boundary]]
where = "top"
fixed = "y"
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = 1e3, rise = 5e-3 }
[time]
end = 2e-2
[[probe]]
name = "end"
at = [1.0, 0.1]
record = ["displacement", "pk1"]
)";

/// A sheet pulled at both ends; its probe lies in the upper right quarter.
const std::string pulled_sheet = head + R"([body]
shape = { box = [[0.0, 0.0], [1.0, 0.6]] }
spacing = 0.1
[[boundary]]
where = "left"
traction = { curve = "smooth-ramp", amplitude = 1e3, rise = 5e-3 }
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = [1e3, 0.0], rise = 5e-3 }
[[boundary]]
where = "left"
traction = [0.0, 0.0]
[time]
end = 2e-2
[[probe]]
name = "corner"
at = [1.0, 0.6]
record = ["displacement", "pk1"]
)";

Scene read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_scene_text(text, "scene", overrides);
}

Scene smaller(const Reduction& reduction) {
  return completed(reduction.scene);
}

TEST(ToOneDimension, OfAStripBetweenRollersIsABar) {
  const Scene scene = read(strip, {"initial.velocity=[0.5,0.0]", "gravity=[1.0,0.0]"});

  const auto reduction = to_one_dimension(scene);

  ASSERT_TRUE(reduction);
  EXPECT_THAT(reduction->what, HasSubstr("depends on y"));
  const Scene bar = smaller(*reduction);
  EXPECT_EQ(bar.dimension, 1);
  ASSERT_EQ(bar.boundaries.size(), 2U);
  EXPECT_EQ(bar.boundaries[0].fixed, std::vector{0});
  EXPECT_TRUE(bar.boundaries[1].normal_traction);
  EXPECT_EQ(bar.body_force, std::vector{1.0});
  EXPECT_EQ(bar.velocity.constant, std::vector{0.5});
  EXPECT_EQ(bar.probes.front().at, std::vector{1.0});
}

class NoBar : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(NoBar, WhereSomethingDependsOnY) {
  EXPECT_FALSE(to_one_dimension(read(strip, GetParam())));
}

INSTANTIATE_TEST_SUITE_P(
    Changes, NoBar,
    testing::Values(
        std::vector<std::string>{"boundary[2].fixed=[\"x\",\"y\"]"},
        std::vector<std::string>{"boundary[2]={where=\"top\",traction=5.0}"},
        std::vector<std::string>{"boundary[3].traction=[1e3,1.0]"},
        std::vector<std::string>{"material.assumption=stress"},
        std::vector<std::string>{"gravity=[0.0,-9.81]"},
        std::vector<std::string>{"initial.velocity={gradient=[[0,1],[0,0]]}"},
        std::vector<std::string>{"body.jitter=0.1"},
        std::vector<std::string>{"body.shape={disc={centre=[0,0],radius=1}}", "probe=[]"},
        std::vector<std::string>{"material.region=[{box=[[0.0,0.0],[0.5,0.1]],young=2e6}]"}));

TEST(ToHalf, OfASheetKeepsTheSideOfItsProbes) {
  const Scene scene = read(pulled_sheet);

  const auto right = to_half(scene, 0);
  const auto upper = to_half(scene, 1);

  ASSERT_TRUE(right && upper);
  EXPECT_THAT(right->what, HasSubstr("x = 0.5 m"));
  EXPECT_THAT(upper->what, HasSubstr("y = 0.3 m"));
  const Scene half = smaller(*right);
  const auto& box = std::get<Box<2>>(std::get<Shape<2>>(half.body.shape).form);
  EXPECT_EQ(box.lower.x(), 0.5);
  EXPECT_EQ(box.upper.x(), 1.0);
  ASSERT_EQ(half.boundaries.size(), 2U);  // both entries of the left went
  EXPECT_EQ(half.boundaries[0].where, "right");
  EXPECT_EQ(half.boundaries[1].where, "left");
  EXPECT_TRUE(half.boundaries[1].symmetry);
}

TEST(ToHalf, TwiceIsAQuarterThatMovesAsTheWhole) {
  const Scene whole = read(pulled_sheet, {"output.frames=0"});
  const Scene half = smaller(*to_half(whole, 0));
  const Scene quarter = smaller(*to_half(half, 1));
  const auto energy = [](const Scene& scene) { return run(scene, {}).energy; };

  const EnergyLedger of_whole = energy(whole);
  const EnergyLedger of_quarter = energy(quarter);

  EXPECT_NEAR(4.0 * of_quarter.elastic / of_whole.elastic, 1.0, 1e-3);
  EXPECT_NEAR(4.0 * of_quarter.external_work / of_whole.external_work, 1.0, 1e-3);
}

TEST(ToHalf, HolesComeInPairs) {
  const auto with_holes = [](const std::string& second) {
    return read(
        pulled_sheet,
        {"body.shape={difference=[{box=[[0,0],[1,0.6]]},{disc={centre=[0.3,0.3],radius=0.1}},"
         "{disc={centre=" +
         second + ",radius=0.1}}]}"});
  };
  const Scene pair = with_holes("[0.7,0.3]");

  const auto half = to_half(pair, 0);

  ASSERT_TRUE(half);
  const Scene right = smaller(*half);
  const auto& shape = std::get<Shape<2>>(right.body.shape);
  EXPECT_EQ(std::get<3>(shape.form)->holes.size(), 1U);
  EXPECT_FALSE(to_half(with_holes("[0.72,0.3]"), 0));
  EXPECT_TRUE(to_half(with_holes("[0.72,0.3]"), 1));
}

class NoHalf : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(NoHalf, WhereTheOtherIsNoImage) {
  EXPECT_FALSE(to_half(read(pulled_sheet, GetParam()), 0));
}

INSTANTIATE_TEST_SUITE_P(
    Changes, NoHalf,
    testing::Values(std::vector<std::string>{"boundary[0].traction.amplitude=2e3"},
                    std::vector<std::string>{"boundary[1].traction.amplitude=[-1e3,0.0]"},
                    std::vector<std::string>{"boundary[2]={where=\"left\",fixed=\"y\"}"},
                    std::vector<std::string>{"boundary[2]={where=\"top\",traction=[1.0,0.0]}"},
                    std::vector<std::string>{"boundary[2]={where=\"outer\",fixed=\"y\"}"},
                    std::vector<std::string>{"gravity=[1.0,0.0]"},
                    std::vector<std::string>{"initial.velocity=[1.0,0.0]"},
                    std::vector<std::string>{"body.jitter=0.1"},
                    std::vector<std::string>{"probe[1]={name=\"left\",at=[0.1,0.1]}"},
                    std::vector<std::string>{
                        "material.region=[{box=[[0.0,0.0],[0.3,0.6]],young=2e6}]"}));

}  // namespace
}  // namespace tlsph

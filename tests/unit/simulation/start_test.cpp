/// What a run says of a start that jumps, and of a law that has no stress there or further on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/core/error.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A bar with E = 1 MPa and ρc = 31.6 kPa s/m whose right end is 1 mm off at t = 0.
const std::string bar = R"(
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.01
[material]
law = "linear-elastic"
assumption = "stress"
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "table", time = [0.0, 1.0], value = [0.001, 0.001] } }
[time]
end = 1e-3
)";

std::vector<std::string> warnings_of(const std::vector<std::string>& overrides) {
  RunOptions options;
  options.threads = 1;
  return run(read_scene_text(bar, "bar.toml", overrides), options).warnings;
}

/// The last cell is strained by 1 mm in 10 mm.
TEST(Start, OfAMotionAwayFromTheBodyIsRemarked) {
  const auto says =
      AllOf(HasSubstr("bar.toml:15:1"), HasSubstr("displacement.x: 0.001 m at t = 0"),
            HasSubstr("up to 0.001 m off the initial displacement"), HasSubstr("about 1e+05 Pa"));

  EXPECT_THAT(warnings_of({}), ElementsAre(says));
  EXPECT_THAT(plan(read_scene_text(bar, "bar.toml", {})).text, says);
}

TEST(Start, OfAMotionAtAnotherSpeedIsRemarkedWithItsWave) {
  const std::string motion = "boundary[1].displacement.x=";

  EXPECT_THAT(warnings_of({motion + "{curve=\"ramp\", amplitude=1e-3, rise=1e-3}"}),
              ElementsAre(AllOf(HasSubstr("displacement.x: 1 m/s at t = 0"),
                                HasSubstr("about 3.2e+04 Pa"))));
  EXPECT_THAT(warnings_of({motion + "{curve=\"smooth-ramp\", amplitude=1e-3, rise=1e-3}"}),
              IsEmpty());
}

TEST(Start, OfABodyThatIsThereIsNotRemarked) {
  EXPECT_THAT(warnings_of({"initial.displacement={gradient=[[0.001]]}"}), IsEmpty());
}

TEST(Start, OfASupportAwayFromTheBodyIsRemarked) {
  EXPECT_THAT(warnings_of({"initial.displacement=[0.001]"}),
              ElementsAre(AllOf(HasSubstr("fixed x"), HasSubstr("up to 0.001 m off"))));
}

/// A sheet of St Venant–Kirchhoff, free of stress across it, ν = 0.4.
const std::string pressed_sheet = R"(
[body]
shape = { box = [[0.0, 0.0], [0.1, 0.02]] }
spacing = 5e-3
[material]
law = "st-venant-kirchhoff"
assumption = "stress"
young = 1e6
poisson = 0.4
density = 1000
[[boundary]]
where = "left"
fixed = "x"
[[boundary]]
where = "right"
displacement = { x = { curve = "smooth-ramp", amplitude = 0.1, rise = 0.4 } }
[time]
end = 0.4
)";

NumericalError failure_of(const std::vector<std::string>& overrides) {
  RunOptions options;
  options.threads = 1;
  try {
    (void)run(read_scene_text(pressed_sheet, "sheet.toml", overrides), options);
  } catch (const NumericalError& error) {
    return error;
  }
  return {"none", -1.0, -1};
}

/// Slowly drawn out, it ends where uniaxial tension ends it, at a stretch of √3.5 = 1.871.
TEST(LawRange, EndsADrawnSheet) {
  const NumericalError error = failure_of({});

  EXPECT_THAT(error.what(), AllOf(testing::StartsWith("the range of the law ended at t = "),
                                  HasSubstr("1 + 2 E_33 > 0"), HasSubstr("1.871")));
  const double s = error.time() / 0.4;
  EXPECT_NEAR(1.0 + s * s * s * (10 + s * (6 * s - 15)), std::sqrt(3.5), 0.03);
  EXPECT_GE(error.particle(), 0);
}

TEST(LawRange, EndsASheetThatStartsOutsideOfIt) {
  const NumericalError error =
      failure_of({"boundary=[{where=\"outer\", held=true}]",
                  "initial.displacement={gradient=[[0.5, 0.2], [0.0, 0.25]]}"});

  EXPECT_THAT(error.what(), testing::StartsWith("the range of the law ended at t = 0"));
  EXPECT_EQ(error.time(), 0.0);
}

/// The run lands on its end, in equal steps no longer than allowed.
TEST(Run, LandsOnItsEnd) {
  const Summary summary = run(read_scene_text(bar, "bar.toml", {}), {});

  EXPECT_EQ(summary.end_time, 1e-3);
  EXPECT_NEAR(summary.dt * static_cast<double>(summary.steps), 1e-3, 1e-15);
  EXPECT_LE(summary.dt, 0.9 * summary.dt_critical * (1.0 + 1e-12));
  EXPECT_GT(summary.dt, 0.6 * summary.dt_critical);
  EXPECT_FALSE(summary.interrupted);
  EXPECT_EQ(summary.failure, "");
}

}  // namespace
}  // namespace tlsph

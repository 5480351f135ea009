/// A run says when, where and at which stretch its material lost its waves.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/core/error.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

/// A bar that is drawn out in homogeneous motion, from F = 1 at t = 0 to F = 4 at t = 0.3 s.
const std::string drawn_bar = R"(
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.49
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "ramp", amplitude = 3.0, rise = 0.3 } }
[initial]
velocity = { gradient = [[10.0]] }
[time]
end = 0.3
[output]
energy_every = 1
)";

Summary run_with(const std::vector<std::string>& overrides) {
  RunOptions options;
  options.threads = 1;
  return run(read_scene_text(drawn_bar, "bar.toml", overrides), options);
}

TEST(HyperbolicityWatch, NamesTimePointAndStretchOfTheFirstLoss) {
  const Summary summary = run_with({});

  ASSERT_TRUE(summary.hyperbolicity_lost);
  const HyperbolicityLoss& loss = *summary.hyperbolicity_lost;
  ASSERT_EQ(loss.stretches.size(), 1U);
  EXPECT_NEAR(loss.stretches[0], 3.6307, 0.01);  // root of dP/dF
  EXPECT_NEAR(loss.time, 0.26307, 0.001);
  EXPECT_LT(loss.acoustic_eigenvalue, 0.0);
  ASSERT_EQ(loss.position.size(), 1U);
  EXPECT_NEAR(loss.position[0], 0.05 + 0.1 * static_cast<double>(loss.point), 1e-12);
  EXPECT_THAT(summary.json(), HasSubstr("\"hyperbolicity_lost\": {"));
  EXPECT_THAT(loss.text(), testing::StartsWith("the material, not the method, lost stability"));
}

TEST(HyperbolicityWatch, FindsNothingInAMaterialThatCarriesWavesAllTheWay) {
  const Summary summary = run_with({"material.poisson=0.48"});

  EXPECT_FALSE(summary.hyperbolicity_lost);
  EXPECT_THAT(summary.json(), HasSubstr("\"hyperbolicity_lost\": null"));
}

/// A bar that is drawn beyond the limit and then pushed through its own other end.
TEST(HyperbolicityWatch, TellsWhatWentBeforeAFailure) {
  try {
    run_with(
        {"boundary[1].displacement.x={curve=\"table\", time=[0.0, 0.3, 0.4], "
         "value=[0.0, 3.0, -2.0]}",
         "time.end=0.4"});
    FAIL() << "a body turned inside out went unnoticed";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("the time step collapsed to"));
    EXPECT_THAT(error.what(), HasSubstr("; before that, the material, not the method, lost"));
  }
}

/// The step of a body that softens without limit stays at its first length: it may stiffen again.
TEST(HyperbolicityWatch, IsNotBlownUpByTheStepOfASoftenedBody) {
  const Summary summary = run_with({"boundary[1].displacement.x.rise=3.0", "time.end=3.0",
                                    "initial.velocity.gradient=[[1.0]]", "body.spacing=0.05"});

  EXPECT_GE(static_cast<double>(summary.steps) * summary.dt, 3.0 * (1 - 1e-12));
  EXPECT_EQ(summary.failure, "");
}

}  // namespace
}  // namespace tlsph

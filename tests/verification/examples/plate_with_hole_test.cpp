/// examples/plate_with_hole.toml: what its header promises. The references are finite elements at
/// rest, printed by validation/sheet_with_hole/stress_concentration.py.

#include <gtest/gtest.h>

#include <cmath>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

/// Stress at A over the traction in the square of five radii while strains are small.
constexpr double concentration = 3.360;

double measured_concentration(const std::string& spacing) {
  const Lesson lesson("plate_with_hole", {"body.spacing=" + spacing, "material.law=linear-elastic",
                                          "boundary[2].traction.amplitude=1e3", "output.frames=0"});
  return lesson.history("A.cauchy_xx").last() / 1e3;
}

TEST(PlateWithHole, GathersTheStressOfSmallStrains) {
  const double coarse = measured_concentration("2.5e-3");
  const double fine = measured_concentration("1.25e-3");

  EXPECT_NEAR(fine / concentration, 1.0, 0.04);
  EXPECT_LE(std::abs(fine - concentration), 0.5 * std::abs(coarse - concentration));
  EXPECT_GT(std::abs(coarse - concentration), 0.01);  // the halving halves something
}

TEST(PlateWithHole, GathersTheStressOfTheSceneAsItStands) {
  const Lesson lesson("plate_with_hole", {"output.frames=0"});

  EXPECT_NEAR(lesson.history("A.cauchy_xx").last() / 16.74e6, 1.0, 0.02);
  EXPECT_NEAR(lesson.history("edge.displacement_x").last() / 3.534e-3, 1.0, 0.005);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-7);
}

}  // namespace
}  // namespace tlsph::lessons

/// examples/stretch.toml: what its header promises.

#include <gtest/gtest.h>

#include <cmath>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

// P = μ(F − 1/F) + λ ln(F)/F at F = 6. The ramp takes 300 transits of the bar, after which the
// oscillation about the static curve is below any of these tolerances.
TEST(Stretch, EndsUniformAtSixTimesItsLength) {
  const double mu = 70e6 / 2.6, lambda = 70e6 * 0.3 / (1.3 * 0.4), F = 6.0;
  const double P = mu * (F - 1 / F) + lambda * std::log(F) / F;

  const Lesson lesson("stretch");

  EXPECT_NEAR(P, 169.111e6, 1e3);
  for (const std::string probe : {"end", "middle"}) {
    EXPECT_NEAR(lesson.history(probe + ".deformation_gradient_xx").last(), F, 1e-4) << probe;
    EXPECT_NEAR(lesson.history(probe + ".pk1_xx").last() / P, 1.0, 1e-3) << probe;
    EXPECT_NEAR(lesson.history(probe + ".cauchy_xx").last() / P, 1.0, 1e-3) << probe;
  }
  ASSERT_TRUE(lesson.summary().errors);
  EXPECT_LE(lesson.summary().errors->stress, 1e-4);
  EXPECT_LE(lesson.summary().errors->displacement, 1e-5);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-7);
}

}  // namespace
}  // namespace tlsph::lessons

/// examples/swinging_plate.toml: what its header promises.

#include <gtest/gtest.h>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

// Bounds a fifth above what 32 x 32 cells of the plain mean gradient give: 4.7e-5, 8.2e-4, 3.5e-4.
TEST(SwingingPlate, IsCloseToTheExactMotion) {
  const Lesson lesson("swinging_plate");

  ASSERT_TRUE(lesson.summary().errors);
  EXPECT_LE(lesson.summary().errors->displacement, 6e-5);
  EXPECT_LE(lesson.summary().errors->velocity, 1e-3);
  EXPECT_LE(lesson.summary().errors->stress, 4e-4);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-8);
}

}  // namespace
}  // namespace tlsph::lessons

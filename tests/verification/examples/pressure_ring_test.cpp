/// examples/pressure_ring.toml: what its header promises.

#include <gtest/gtest.h>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

constexpr double bore = 0.95333e-6, rim = 0.60667e-6, hoop = 16.667e6;

TEST(PressureRing, StandsAsLameSays) {
  const Lesson lesson("pressure_ring");

  EXPECT_NEAR(lesson.history("bore.displacement_x").last(), bore, 0.002 * bore);
  EXPECT_NEAR(lesson.history("rim.displacement_x").last(), rim, 0.002 * rim);
  EXPECT_NEAR(lesson.history("bore.cauchy_yy").last(), hoop, 0.01 * hoop);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-6);
}

TEST(PressureRing, WithStressPointsOnEdges) {
  const Lesson lesson("pressure_ring", {"formulation=stress-point"});

  EXPECT_NEAR(lesson.history("bore.displacement_x").last(), bore, 0.004 * bore);
  EXPECT_NEAR(lesson.history("rim.displacement_x").last(), rim, 0.004 * rim);
  EXPECT_NEAR(lesson.history("bore.cauchy_yy").last(), hoop, 0.03 * hoop);
}

/// The adjoint matters: without its correction the error is ten times as large.
TEST(PressureRing, NeedsAnExactAdjoint) {
  const Lesson lesson("pressure_ring", {"formulation=variational"});

  EXPECT_GT(lesson.history("bore.displacement_x").last(), 1.02 * bore);
}

}  // namespace
}  // namespace tlsph::lessons

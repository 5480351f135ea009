/// examples/clamped_beam.toml: what its header promises.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "lesson.hpp"
#include "tlsph/analysis/history.hpp"

namespace tlsph::lessons {
namespace {

/// First period of the plate in two-dimensional elasticity at small amplitude [s].
constexpr double exact_period = 0.25523;

struct Fineness {
  int cells;         ///< through the thickness
  double tolerance;  ///< of the period, relative: a quarter with each halving
};

void PrintTo(const Fineness& fineness, std::ostream* out) {
  *out << fineness.cells << " cells";
}

class ClampedBeam : public testing::TestWithParam<Fineness> {};

TEST_P(ClampedBeam, SwingsWithItsFirstPeriod) {
  const auto [cells, tolerance] = GetParam();

  const Lesson lesson("clamped_beam", {fmt::format("body.spacing={}", 0.02 / cells)});

  const History tip = lesson.history("tip.displacement_y");
  const double period = mean_period(tip.time, tip.value);
  ASSERT_EQ(passages(tip.time, tip.value).size(), 6U);  // three periods
  EXPECT_NEAR(period / exact_period, 1.0, tolerance);
  EXPECT_NEAR(tip.largest_magnitude(), 1e-3, 2e-5);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-8);
  fmt::print("clamped beam, {} cells: first period {:.5f} s, {:+.2f} %\n", cells, period,
             100 * (period / exact_period - 1));
}

INSTANTIATE_TEST_SUITE_P(CellsThroughTheThickness, ClampedBeam,
                         testing::Values(Fineness{4, 0.0032}, Fineness{8, 0.0016},
                                         Fineness{16, 0.0007}),
                         [](const auto& one) { return std::to_string(one.param.cells); });

}  // namespace
}  // namespace tlsph::lessons

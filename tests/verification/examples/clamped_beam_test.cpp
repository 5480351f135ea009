/// examples/clamped_beam.toml: what its header promises.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

/// First period of the plate in two-dimensional elasticity at small amplitude [s].
constexpr double exact_period = 0.25523;

/// Twice the slope of the straight line through the passages against their number: successive half
/// periods differ by the other modes that the initial field excites, their mean does not.
double mean_period(const std::vector<double>& passages) {
  const double middle = 0.5 * static_cast<double>(passages.size() - 1);
  double slope = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < passages.size(); ++k) {
    const double from_middle = static_cast<double>(k) - middle;
    slope += from_middle * passages[k];
    squares += from_middle * from_middle;
  }
  return 2.0 * slope / squares;
}

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
  const std::vector<double> passages = tip.passages(0.0);
  ASSERT_EQ(passages.size(), 6U);  // three periods
  EXPECT_NEAR(mean_period(passages) / exact_period, 1.0, tolerance);
  EXPECT_NEAR(tip.largest_magnitude(), 1e-3, 2e-5);
  EXPECT_LE(lesson.summary().energy.drift_relative, 1e-8);
  fmt::print("clamped beam, {} cells: first period {:.5f} s, {:+.2f} %\n", cells,
             mean_period(passages), 100 * (mean_period(passages) / exact_period - 1));
}

INSTANTIATE_TEST_SUITE_P(CellsThroughTheThickness, ClampedBeam,
                         testing::Values(Fineness{4, 0.0032}, Fineness{8, 0.0016},
                                         Fineness{16, 0.0007}),
                         [](const auto& one) { return std::to_string(one.param.cells); });

}  // namespace
}  // namespace tlsph::lessons

/// examples/bar_wave.toml and bar_wave_2d.toml: what their headers promise.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lesson.hpp"
#include "tlsph/analysis/history.hpp"

namespace tlsph::lessons {
namespace {

constexpr double density = 8000;      // [kg/m³]
constexpr double amplitude = -100e3;  // [Pa]
constexpr double rise = 1e-6;         // [s]
constexpr double duration = 8e-6;     // [s]

/// c = √((λ + 2μ)/ρ) for E = 200 GPa and ν = 0.3: 5801 m/s.
double wave_speed() {
  const double young = 200e9, poisson = 0.3;
  return std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density);
}

/// p(t) = A/2 [erf((t − 3r)/r) − erf((t − 3r − T)/r)]: half of A is reached at 3r.
double pulse(double t) {
  return 0.5 * amplitude *
         (std::erf((t - 3 * rise) / rise) - std::erf((t - 3 * rise - duration) / rise));
}

/// The front, half the amplitude, is at x after 3r + x/c: its way there, within 0.2 %.
void expect_arrival(const History& stress, double x) {
  const std::vector<double> fronts = passages(stress.time, stress.value, 0.5 * amplitude);
  ASSERT_FALSE(fronts.empty()) << "no front at " << x;
  EXPECT_NEAR((fronts.front() - 3 * rise) / (x / wave_speed()), 1.0, 2e-3) << "at " << x;
}

TEST(BarWave, AgreesWithDAlembert) {
  const Lesson lesson("bar_wave");

  ASSERT_TRUE(lesson.summary().errors);
  EXPECT_LE(lesson.summary().errors->stress, 1e-3);
  EXPECT_LE(lesson.summary().errors->displacement, 5e-5);
  EXPECT_NEAR(wave_speed(), 5801, 1);
  expect_arrival(lesson.history("p2.pk1_xx"), 0.05);
  expect_arrival(lesson.history("p3.pk1_xx"), 0.10);
  EXPECT_NEAR(lesson.history("p4.pk1_xx").lowest() / (2 * amplitude), 1.0, 5e-3);
  EXPECT_EQ(lesson.history("p4.displacement_x").largest_magnitude(), 0.0);
}

class BarWaveWithGhosts : public testing::TestWithParam<const char*> {};

// Formulations that impose the traction on the stress of the loaded particle itself.
TEST_P(BarWaveWithGhosts, ReproducesTheTractionAndTheFixedEnd) {
  const Lesson lesson("bar_wave", {std::string("formulation=") + GetParam()});

  const History loaded = lesson.history("p1.pk1_xx");
  ASSERT_GT(loaded.time.size(), 300U);
  for (std::size_t k = 0; k < loaded.time.size(); ++k)
    ASSERT_NEAR(loaded.value[k], pulse(loaded.time[k]), 1e-9 * std::abs(amplitude))
        << "at t = " << loaded.time[k];
  EXPECT_EQ(lesson.history("p4.displacement_x").largest_magnitude(), 0.0);
  EXPECT_GT(lesson.history("p3.displacement_x").largest_magnitude(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Formulations, BarWaveWithGhosts, testing::Values("mirror", "thesis"),
                         [](const auto& one) { return std::string(one.param); });

TEST(BarWave2D, IsTheWaveOfTheBar) {
  const Lesson lesson("bar_wave_2d");

  ASSERT_TRUE(lesson.summary().errors);
  EXPECT_LE(lesson.summary().errors->stress, 2e-3);
  expect_arrival(lesson.history("p2.pk1_xx"), 0.05);
  EXPECT_NEAR(lesson.history("p4.pk1_xx").lowest() / (2 * amplitude), 1.0, 5e-3);
  EXPECT_EQ(lesson.history("p4.displacement_x").largest_magnitude(), 0.0);
}

// Six nodes stand above each other at each X: they move as one.
TEST(BarWave2D, IsPlane) {
  const Lesson lesson("bar_wave_2d");

  const VectorField<2> X = lesson.nodes();
  const VectorField<2> u = lesson.last_displacement();
  const double scale = u.cwiseAbs().maxCoeff();
  std::map<long, std::vector<double>> columns;
  for (Index q = 0; q < X.rows(); ++q) columns[std::lround(X(q, 0) / 5e-4)].push_back(u(q, 0));
  ASSERT_EQ(columns.size(), 301U);
  for (const auto& [column, motion] : columns) {
    ASSERT_EQ(motion.size(), 6U);
    for (const double other : motion) EXPECT_NEAR(other, motion.front(), 1e-9 * scale) << column;
  }
  EXPECT_GT(scale, 1e-8);
  EXPECT_LE(u.col(1).cwiseAbs().maxCoeff(), 1e-6 * scale);
}

}  // namespace
}  // namespace tlsph::lessons

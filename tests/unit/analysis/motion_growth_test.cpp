#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tlsph {
namespace {

using Spectrum = std::vector<std::complex<double>>;

TEST(GrowthRate, IsTheRootOfANegativeSquare) {
  EXPECT_EQ(growth_rate(Spectrum{{4.0, 0.0}, {1.0, 0.0}}), 0.0);
  EXPECT_DOUBLE_EQ(growth_rate(Spectrum{{4.0, 0.0}, {-9.0, 0.0}}), 3.0);
}

TEST(GrowthPerStep, StartsAtTheLimitOfTheCentralDifference) {
  const Spectrum spectrum = {{4.0, 0.0}};  // ω = 2, Δt = 1 is the limit

  EXPECT_NEAR(growth_per_step(spectrum, 0.99), 0.0, 1e-12);
  // z + 1/z = 2 − ω²Δt²: ln|z| = 2 arcosh(ωΔt/2)
  EXPECT_NEAR(growth_per_step(spectrum, 1.02), 2.0 * std::acosh(1.02), 1e-12);
}

TEST(FittedGrowth, IsTheSlopeOfTheLogarithmBetweenTheLimits) {
  std::vector<double> time, values;
  for (int n = 0; n < 200; ++n) {
    time.push_back(0.1 * n);
    values.push_back(1e-3 + 1e-6 * std::exp(1.5 * time.back()));
  }

  EXPECT_NEAR(growth_rate(time, values, 1.0, 1e5), 1.5, 1e-3);
  EXPECT_TRUE(std::isnan(growth_rate(time, values, 1e9, 1e12)));
}

}  // namespace
}  // namespace tlsph

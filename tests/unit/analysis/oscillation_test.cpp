#include "tlsph/analysis/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tlsph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;

struct Samples {
  std::vector<double> time, values;
};

/// `f` at n + 1 instants of [0, end].
Samples sampled(int n, double end, auto f) {
  Samples samples;
  for (int k = 0; k <= n; ++k) {
    samples.time.push_back(end * k / n);
    samples.values.push_back(f(samples.time.back()));
  }
  return samples;
}

TEST(Maximum, IsTheSummitOfAParabolaWhereverTheSamplesLie) {
  const std::vector<double> time = {0.0, 0.3, 0.9, 1.0, 1.6};
  std::vector<double> valley;
  std::vector<double> hill;
  for (const double t : time) {
    valley.push_back(3.0 * (t - 0.7) * (t - 0.7) - 5.0);
    hill.push_back(-valley.back());
  }

  EXPECT_NEAR(minimum(time, valley), -5.0, 1e-14);
  EXPECT_NEAR(maximum(time, hill), 5.0, 1e-14);
}

TEST(Maximum, OfAWaveErrsWithTheFourthPowerOfTheStep) {
  // The largest sample lies off the summit by a share of the step that does not change.
  const auto error = [](int n) {
    const Samples s = sampled(4 * n, 4.0, [&](double t) { return std::cos(t - 2.0 - 0.3 / n); });
    return std::abs(maximum(s.time, s.values) - 1.0);
  };

  EXPECT_NEAR(std::log2(error(10) / error(20)), 4.0, 0.2);
  EXPECT_LT(error(20), 1e-6);
}

TEST(Maximum, AtAnEndOrOnAPlateauIsASample) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 3.0};

  EXPECT_EQ(maximum(time, std::vector{1.0, 2.0, 3.0, 4.0}), 4.0);
  EXPECT_EQ(minimum(time, std::vector{-9.0, 2.0, 3.0, 4.0}), -9.0);
  EXPECT_EQ(maximum(time, std::vector{2.0, 2.0, 2.0, 2.0}), 2.0);
  EXPECT_EQ(maximum(std::vector{0.0}, std::vector{7.0}), 7.0);
}

TEST(Passages, LieBetweenTheSamples) {
  const std::vector<double> time = {0.0, 1.0, 2.0, 4.0, 5.0};

  EXPECT_THAT(passages(time, std::vector{0.0, 1.0, -3.0, 1.0, 0.0}),
              ElementsAre(1.25, DoubleNear(3.5, 1e-15), 5.0));
  EXPECT_THAT(passages(time, std::vector{0.0, 1.0, 2.0, 3.0, 4.0}), IsEmpty());
  EXPECT_THAT(passages(time, std::vector{0.0, 1.0, 2.0, 3.0, 4.0}, 1.5), ElementsAre(1.5));
}

TEST(MeanPeriod, IsThatOfTheLowestMode) {
  const Samples s = sampled(4000, 3.3, [](double t) {
    return std::sin(2.0 * std::numbers::pi * t) + 0.05 * std::sin(13.7 * std::numbers::pi * t);
  });

  EXPECT_NEAR(mean_period(s.time, s.values), 1.0, 5e-3);
}

TEST(MeanPeriod, OfAShiftedSineIsExactToTheSamples) {
  const Samples s = sampled(
      2000, 5.0, [](double t) { return 4.0 + 2.0 * std::sin(2.0 * std::numbers::pi * t / 0.8); });

  EXPECT_NEAR(mean_period(s.time, s.values, 4.0), 0.8, 1e-6);
}

TEST(MeanPeriod, IsNoneWhereNothingOscillates) {
  const Samples once = sampled(100, 0.9, [](double t) { return std::cos(std::numbers::pi * t); });
  const Samples pulses = sampled(1000, 10.0, [](double t) {
    return t < 1.0 || t > 9.0 ? std::sin(2.0 * std::numbers::pi * t) : -0.1;
  });

  EXPECT_TRUE(std::isnan(mean_period(once.time, once.values)));
  EXPECT_TRUE(std::isnan(mean_period(pulses.time, pulses.values)));
}

}  // namespace
}  // namespace tlsph

#include "tlsph/analysis/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tlsph {
namespace {

using testing::ElementsAre;

std::vector<double> mapped(const std::vector<double>& t, auto f) {
  std::vector<double> values;
  for (const double x : t) values.push_back(f(x));
  return values;
}

TEST(Resample, ReproducesCubicsOnUnevenSteps) {
  const std::vector<double> t = {0.0, 0.1, 0.3, 0.35, 0.7, 1.0};
  const std::vector<double> at = {0.0, 0.05, 0.1, 0.2, 0.33, 0.5, 0.69, 0.9, 1.0};
  const auto cubic = [](double x) { return 2.0 - x + 3.0 * x * x - 4.0 * x * x * x; };

  const auto values = resample(t, mapped(t, cubic), at);

  for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(values[k], cubic(at[k]), 1e-14) << at[k];
}

TEST(Resample, ErrsWithTheFourthPower) {
  const auto error = [](int n) {
    std::vector<double> t;
    std::vector<double> at;
    for (int k = 0; k <= n; ++k) t.push_back(k / static_cast<double>(n));
    for (int k = 0; k <= 1000; ++k) at.push_back(k / 1000.0);
    const auto wave = [](double x) { return std::sin(2.0 * std::numbers::pi * x); };
    const auto values = resample(t, mapped(t, wave), at);
    double largest = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k)
      largest = std::max(largest, std::abs(values[k] - wave(at[k])));
    return largest;
  };

  EXPECT_NEAR(std::log2(error(20) / error(40)), 4.0, 0.2);
  EXPECT_LT(error(40), 3e-5);
}

TEST(Resample, TakesWhatThereIsOfFewSamples) {
  const std::vector<double> at = {-1.0, 0.5, 9.0};

  EXPECT_THAT(resample(std::vector{0.0}, std::vector{3.0}, at), ElementsAre(3.0, 3.0, 3.0));
  EXPECT_THAT(resample(std::vector{0.0, 1.0}, std::vector{3.0, 5.0}, at),
              ElementsAre(3.0, 4.0, 5.0));
  EXPECT_THAT(resample(std::vector{0.0, 1.0, 2.0}, std::vector{0.0, 1.0, 4.0}, at),
              ElementsAre(0.0, 0.25, 4.0));
}

TEST(SquaredNorm, IsTheTrapezoidalIntegral) {
  EXPECT_DOUBLE_EQ(squared_norm(std::vector{0.0, 1.0, 3.0}, std::vector{2.0, 1.0, -3.0}),
                   0.5 * (4.0 + 1.0) + 1.0 * (1.0 + 9.0));
}

}  // namespace
}  // namespace tlsph

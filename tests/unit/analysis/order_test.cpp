#include "tlsph/analysis/order.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tlsph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsNan;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> powers(const std::vector<double>& h, double C, double p) {
  std::vector<double> e;
  for (const double x : h) e.push_back(C * std::pow(x, p));
  return e;
}

std::vector<double> successive(const std::vector<double>& e) {
  std::vector<double> d;
  for (std::size_t k = 1; k < e.size(); ++k) d.push_back(std::abs(e[k - 1] - e[k]));
  return d;
}

TEST(PairwiseOrders, OfPowersAreTheExponent) {
  const std::vector<double> h = {0.4, 0.2, 0.15, 0.01};

  const auto orders = pairwise_orders(h, powers(h, 7.0, 1.5));

  EXPECT_THAT(orders, ElementsAre(IsNan(), DoubleNear(1.5, 1e-13), DoubleNear(1.5, 1e-13),
                                  DoubleNear(1.5, 1e-13)));
}

TEST(PairwiseOrders, AreUnknownBesideAnErrorThatIsNone) {
  const std::vector<double> h = {16, 8, 4, 2, 1};

  EXPECT_THAT(
      pairwise_orders(h, std::vector{16.0, 8.0, nan, 2.0, 1.0}),
      ElementsAre(IsNan(), DoubleNear(1.0, 1e-14), IsNan(), IsNan(), DoubleNear(1.0, 1e-14)));
  EXPECT_THAT(pairwise_orders(h, std::vector{16.0, 0.0, 4.0, infinity, 1.0}),
              ElementsAre(IsNan(), IsNan(), IsNan(), IsNan(), IsNan()));
}

TEST(FitOrder, OfPowersIsExactAndSure) {
  const std::vector<double> h = {0.4, 0.2, 0.15, 0.01};

  const OrderFit fit = fit_order(h, powers(h, 7.0, 1.5));

  EXPECT_NEAR(fit.order, 1.5, 1e-13);
  EXPECT_NEAR(std::exp(fit.log_constant), 7.0, 1e-12);
  EXPECT_NEAR(fit.standard_error, 0.0, 1e-13);
  EXPECT_EQ(fit.points, 4);
}

// ln h = 2, 1, 0 and ln e = 4, 3, 0: slope 2, intercept 1/3, residuals −1/3, 2/3, −1/3, so that
// s² = (6/9)/1 and the standard error of the slope is √(s²/Σ(x−x̄)²) = √(1/3).
TEST(FitOrder, HasTheHandNumbers) {
  const std::vector<double> h = {std::exp(2.0), std::exp(1.0), 1.0};
  const std::vector<double> e = {std::exp(4.0), std::exp(3.0), 1.0};

  const OrderFit fit = fit_order(h, e);

  EXPECT_NEAR(fit.order, 2.0, 1e-14);
  EXPECT_NEAR(fit.log_constant, 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(fit.standard_error, std::sqrt(1.0 / 3.0), 1e-14);
}

TEST(FitOrder, LeavesOutWhatIsNoError) {
  const std::vector<double> h = {8, 4, 2, 1};

  const OrderFit fit = fit_order(h, std::vector{nan, 16.0, 0.0, 1.0});

  EXPECT_NEAR(fit.order, 2.0, 1e-14);
  EXPECT_TRUE(std::isnan(fit.standard_error));
  EXPECT_EQ(fit.points, 2);
  EXPECT_TRUE(std::isnan(fit_order(h, std::vector{nan, 16.0, 0.0, nan}).order));
  EXPECT_TRUE(std::isnan(fit_order({}, {}).order));
}

class DifferenceOrder : public testing::TestWithParam<double> {};

TEST_P(DifferenceOrder, IsThatOfTheErrorsForAnyRatios) {
  const double p = GetParam();
  for (const std::vector<double>& h :
       {std::vector{0.4, 0.2, 0.1}, std::vector{1.0, 0.7, 0.3, 0.25, 0.01}}) {
    const std::vector<double> d = successive(powers(h, 3.0, p));

    const OrderFit fit = fit_order_of_differences(h, d);

    EXPECT_NEAR(fit.order, p, 1e-9);
    EXPECT_NEAR(std::exp(fit.log_constant), 3.0, 1e-8);
    EXPECT_EQ(fit.points, static_cast<int>(d.size()));
  }
}

TEST_P(DifferenceOrder, PairwiseNeedsThreeRuns) {
  const std::vector<double> h = {1.0, 0.7, 0.3, 0.25};

  const auto orders = pairwise_orders_of_differences(h, successive(powers(h, 3.0, GetParam())));

  EXPECT_THAT(orders, ElementsAre(IsNan(), IsNan(), DoubleNear(GetParam(), 1e-9),
                                  DoubleNear(GetParam(), 1e-9)));
}

INSTANTIATE_TEST_SUITE_P(Orders, DifferenceOrder, testing::Values(-1.0, 0.5, 1.0, 2.0, 4.0, 9.0));

TEST(DifferenceOrder, WithAConstantRatioIsTheSlopeOfTheLine) {
  const std::vector<double> h = {8, 4, 2, 1};
  const std::vector<double> d = {50.0, 11.0, 3.3};

  const OrderFit fit = fit_order_of_differences(h, d);
  const OrderFit line = fit_order(std::vector{8.0, 4.0, 2.0}, d);

  EXPECT_NEAR(fit.order, line.order, 1e-12);
  EXPECT_NEAR(fit.standard_error, line.standard_error, 1e-12);
  EXPECT_GT(fit.standard_error, 0.01);
}

TEST(DifferenceOrder, IsUnknownWithoutTwoDifferences) {
  EXPECT_TRUE(std::isnan(fit_order_of_differences(std::vector{2.0, 1.0}, std::vector{1.0}).order));
  EXPECT_TRUE(std::isnan(
      fit_order_of_differences(std::vector{4.0, 2.0, 1.0}, std::vector{1.0, 0.0}).order));
  EXPECT_THAT(pairwise_orders_of_differences(std::vector{2.0, 1.0}, std::vector{1.0}),
              ElementsAre(IsNan(), IsNan()));
}

TEST(Richardson, FindsTheLimitOfAPower) {
  const double limit = 10.0;
  const auto value = [&](double h) { return limit + 3.0 * std::pow(h, 2.5); };

  EXPECT_NEAR(richardson_limit(value(0.3), value(0.1), 3.0, 2.5), limit, 1e-13);
  EXPECT_NEAR(richardson_error(value(0.3) - value(0.1), 3.0, 2.5), value(0.1) - limit, 1e-13);
}

TEST(Richardson, HasNoLimitWithoutConvergence) {
  EXPECT_TRUE(std::isnan(richardson_limit(2.0, 1.0, 2.0, 0.0)));
  EXPECT_TRUE(std::isnan(richardson_error(1.0, 2.0, -1.0)));
  EXPECT_TRUE(std::isnan(richardson_error(1.0, 2.0, nan)));
}

}  // namespace
}  // namespace tlsph

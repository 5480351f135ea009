#include "tlsph/studies/chart_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tlsph/core/error.hpp"
#include "tlsph/studies/chart.hpp"

namespace tlsph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Eq;
using testing::HasSubstr;
using testing::Optional;
using testing::ThrowsMessage;

const double none = std::numeric_limits<double>::quiet_NaN();

TEST(ParetoFront, HoldsWhatNothingIsFasterAndNearerThan) {
  //                              front  behind  front  slower  front  lost
  const std::vector<double> times = {1.0, 2.0, 3.0, 3.5, 4.0, 0.5};
  const std::vector<double> errors = {0.5, 0.6, 0.2, 0.2, 0.1, none};

  EXPECT_THAT(pareto_front(times, errors), ElementsAre(true, false, true, false, true, false));
}

TEST(ParetoFront, KeepsTwins) {
  EXPECT_THAT(pareto_front({1.0, 1.0}, {0.5, 0.5}), ElementsAre(true, true));
}

TEST(Predict, FromOneRunTakesTheOrdersOfTheMethod) {
  const Predicted run = predict({{0.2, 1.0, 8.0, {0.04, none}}}, 0.1, 2);

  EXPECT_DOUBLE_EQ(run.stepping, 64.0);  // h⁻³ in 2D
  EXPECT_DOUBLE_EQ(run.setup, 4.0);      // h⁻²
  EXPECT_DOUBLE_EQ(run.errors[0], 0.01);
  EXPECT_TRUE(std::isnan(run.errors[1]));
  EXPECT_DOUBLE_EQ(run.cost(), 68.0);
}

TEST(Predict, FromTwoRunsTakesWhatTheyShowWithinReason) {
  const std::vector<Measured> runs = {{0.4, 1.0, 1.0, {0.8, 0.8, 0.1}},
                                      {0.2, 6.0, 5.0, {0.4, 1e-6, 0.2}}};

  const Predicted run = predict(runs, 0.1, 1);

  EXPECT_DOUBLE_EQ(run.stepping, 25.0);                    // log2 5, between 2 and 3
  EXPECT_DOUBLE_EQ(run.setup, 6.0 * std::pow(2.0, 2.5));   // log2 6 is more than is believed
  EXPECT_DOUBLE_EQ(run.errors[0], 0.1 * std::sqrt(2.0));   // first order: 1.5 is hoped for
  EXPECT_DOUBLE_EQ(run.errors[1], 1e-6 / 16.0);            // luck: order 4 is the largest
  EXPECT_DOUBLE_EQ(run.errors[2], 0.05 * std::sqrt(2.0));  // grew: the same
}

TEST(Judged, TakesNoLuckFromSingleNumbers) {
  // The second run hits the answer by chance, fields are left alone.
  const std::vector<Measured> runs = {
      {0.4, 0.0, 0.0, {8e-2, 8e-2}}, {0.2, 0.0, 0.0, {1e-9, 1e-9}}, {0.1, 0.0, 0.0, {5e-3, 5e-3}}};

  const std::vector<Measured> fair = judged(runs, {true, false});

  EXPECT_THAT(fair[0].errors, ElementsAre(8e-2, 8e-2));
  EXPECT_THAT(fair[1].errors, ElementsAre(DoubleNear(1e-2, 1e-15), 1e-9));  // 8e-2/2³ > 5e-3
  EXPECT_THAT(fair[2].errors, ElementsAre(5e-3, 5e-3));
}

TEST(Judged, LeavesASecondOrderFamilyAsItIs) {
  std::vector<Measured> runs;
  for (const double h : {0.4, 0.2, 0.1}) runs.push_back({h, 0.0, 0.0, {h * h}});

  const std::vector<Measured> fair = judged(runs, {true});

  for (std::size_t k = 0; k < runs.size(); ++k) EXPECT_EQ(fair[k].errors, runs[k].errors);
}

TEST(Judged, DoesNotBelieveASingleRun) {
  EXPECT_TRUE(std::isnan(judged({{0.4, 0.0, 0.0, {1e-3}}}, {true})[0].errors[0]));
  EXPECT_EQ(judged({{0.4, 0.0, 0.0, {1e-3}}}, {false})[0].errors[0], 1e-3);
}

TEST(Promise, IsHowFarARunReachesBeyondTheFront) {
  const std::vector<Measured> all = {{0.4, 0.0, 1.0, {0.1}}, {0.2, 0.0, 10.0, {0.02}}};

  EXPECT_NEAR(promise({0.0, 5.0, {0.05}}, all, 1.0), std::log(2.0), 1e-12);
  EXPECT_NEAR(promise({0.0, 20.0, {0.05}}, all, 1.0), std::log(0.4), 1e-12);
  EXPECT_NEAR(promise({0.0, 20.0, {0.02}}, all, 1.25), std::log(1.25), 1e-12);
  EXPECT_GT(promise({0.0, 0.5, {0.05}}, all, 1.0), std::log(20.0));  // nothing is as fast
  EXPECT_LT(promise({0.0, 0.5, {none}}, all, 1.0), 0.0);
}

TEST(Promise, OfSeveralQuantitiesIsTheBest) {
  const std::vector<Measured> all = {{0.4, 0.0, 1.0, {0.1, 0.1}}};

  EXPECT_NEAR(promise({0.0, 5.0, {0.2, 0.01}}, all, 1.0), std::log(10.0), 1e-12);
}

TEST(BestProspect, GainsMostForItsTimeAndFits) {
  const std::vector<Prospect> prospects = {{1.0, 1.0}, {3.0, 2.0}, {9.0, 3.0}, {-1.0, 0.1}};

  EXPECT_THAT(best_prospect(prospects, 10.0), Optional(Eq(2U)));
  EXPECT_THAT(best_prospect(prospects, 2.5), Optional(Eq(1U)));
  EXPECT_EQ(best_prospect(prospects, 0.5), std::nullopt);
  EXPECT_EQ(best_prospect({}, 1.0), std::nullopt);
}

TEST(ParseChartValue, ReadsNameAndAnswer) {
  const ChartValue known = parse_chart_value("tip.displacement_y.period=0.25523");
  const ChartValue unknown = parse_chart_value("tip.displacement_y.period");

  EXPECT_EQ(known.name, "tip.displacement_y.period");
  EXPECT_THAT(known.answer, Optional(0.25523));
  EXPECT_EQ(unknown.answer, std::nullopt);
  for (const char* text : {"a.b=", "a.b=x", "a.b=1.5s", "a.b=0", "a.b=inf"})
    EXPECT_THAT([&] { (void)parse_chart_value(text); },
                ThrowsMessage<InputError>(HasSubstr("must be a number")));
}

}  // namespace
}  // namespace tlsph

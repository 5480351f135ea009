#include "tlsph/studies/converge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double infinite = std::numeric_limits<double>::infinity();
const double not_known = std::nan("");

TEST(SpreadOf, SamplesIsTheBestTheMiddleAndTheWorst) {
  const Spread odd = spread_of({5.0, 1.0, 3.0});
  const Spread even = spread_of({4.0, 1.0, 2.0, 8.0});
  const Spread one = spread_of({7.0});

  EXPECT_THAT((std::vector{odd.best, odd.median, odd.worst}), ElementsAre(1.0, 3.0, 5.0));
  EXPECT_THAT((std::vector{even.best, even.median, even.worst}), ElementsAre(1.0, 3.0, 8.0));
  EXPECT_THAT((std::vector{one.best, one.median, one.worst}), ElementsAre(7.0, 7.0, 7.0));
}

TEST(SpreadOf, TakesAFailureForTheWorstAndLeavesOutWhatIsNoNumber) {
  const Spread third = spread_of({infinite, 1.0, 2.0});
  const Spread half = spread_of({infinite, 1.0});
  const Spread gaps = spread_of({not_known, 3.0, not_known});

  EXPECT_THAT((std::vector{third.best, third.median, third.worst}),
              ElementsAre(1.0, 2.0, infinite));
  EXPECT_EQ(half.median, infinite);
  EXPECT_EQ(gaps.median, 3.0);
  EXPECT_TRUE(std::isnan(spread_of({not_known}).worst));
}

/// A run of the one series there is, with an error and a value.
ConvergenceRow row(double spacing, double error, double value = 0.0, std::string failure = "") {
  ConvergenceRow row;
  row.series = row.formulation = "consistent";
  row.spacing = spacing;
  row.particles = std::lround(1.0 / (spacing * spacing));
  row.errors = {error};
  row.values = {value};
  row.failure = std::move(failure);
  return row;
}

TEST(FindOrders, OfSamplesAreThoseOfTheMediansAndOfTheWorst) {
  std::vector<ConvergenceRow> rows;
  for (const double h : {0.4, 0.2, 0.1})
    for (const double factor : {1.0, 0.5, 3.0 * h}) rows.push_back(row(h, factor * h * h));

  const SeriesOrders found = find_orders(rows, {"velocity"}, ConvergenceMethod::exact);

  // factors 1, 0.5, 3 h: worst 1.2, 1, 1; middle 1, 0.6, 0.5; best 0.5, 0.5, 0.3
  ASSERT_EQ(found.levels.size(), 3);
  EXPECT_EQ(found.levels[1].runs, 3);
  EXPECT_NEAR(found.levels[0].errors[0].worst, 1.2 * 0.16, 1e-15);
  EXPECT_NEAR(found.levels[1].errors[0].median, 0.6 * 0.04, 1e-15);
  EXPECT_NEAR(found.levels[2].errors[0].best, 0.3 * 0.01, 1e-15);
  EXPECT_NEAR(found.levels[1].median_orders[0], 2.0 + std::log2(1.0 / 0.6), 1e-12);
  EXPECT_NEAR(found.levels[2].worst_orders[0], 2.0, 1e-12);
  EXPECT_NEAR(found.fits[0].fit.order, 2.0 + 0.5 * std::log2(1.0 / 0.5), 1e-12);
  EXPECT_NEAR(found.fits[0].worst_fit.order, 2.0 + 0.5 * std::log2(1.2), 1e-12);
}

TEST(FindOrders, PassOverALevelThatFailed) {
  const std::vector<ConvergenceRow> rows = {row(0.4, 16.0), row(0.2, not_known, 0.0, "blew up"),
                                            row(0.1, 1.0)};

  const SeriesOrders found = find_orders(rows, {"velocity"}, ConvergenceMethod::exact);

  EXPECT_EQ(found.levels[1].failed, 1);
  EXPECT_TRUE(std::isnan(found.levels[1].median_orders[0]));
  EXPECT_NEAR(found.levels[2].median_orders[0], 2.0, 1e-12);
  EXPECT_EQ(found.fits[0].fit.points, 2);
}

TEST(FindOrders, OneFailureSpoilsTheWorstNotTheMedian) {
  std::vector<ConvergenceRow> rows;
  for (const double h : {0.4, 0.2, 0.1})
    for (int sample = 0; sample < 3; ++sample) rows.push_back(row(h, h * h));
  rows[4].failure = "blew up";

  const SeriesOrders found = find_orders(rows, {"velocity"}, ConvergenceMethod::exact);

  EXPECT_EQ(found.levels[1].errors[0].worst, infinite);
  EXPECT_NEAR(found.levels[1].median_orders[0], 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(found.levels[1].worst_orders[0]));
}

// Differences d_k of runs with errors C h²: what is left in the finest is C h².
TEST(FindOrders, OfDifferencesTellWhatIsLeft) {
  const std::vector<ConvergenceRow> rows = {row(0.4, 7.0 * (0.16 - 0.04)),
                                            row(0.2, 7.0 * (0.04 - 0.01)), row(0.1, not_known)};

  const SeriesOrders found = find_orders(rows, {"velocity"}, ConvergenceMethod::probes);

  EXPECT_NEAR(found.fits[0].fit.order, 2.0, 1e-9);
  EXPECT_NEAR(found.fits[0].finest_error, 7.0 * 0.01, 1e-9);
}

TEST(FindLimits, ExtrapolateTheMediansOfTheFinestThree) {
  std::vector<ConvergenceRow> rows = {row(0.8, not_known, 99.0)};
  for (const double h : {0.4, 0.2, 0.1})
    for (const double off : {-1.0, 0.0, 1.0})
      rows.push_back(row(h, not_known, 5.0 - 2.0 * std::pow(h, 1.5) + off * h));

  const std::vector<ConvergenceValue> values = find_limits(rows, {"tip.displacement_y.peak"});

  ASSERT_EQ(values.size(), 1);
  EXPECT_EQ(values[0].name, "tip.displacement_y.peak");
  EXPECT_EQ(values[0].medians.size(), 4);
  EXPECT_NEAR(values[0].order, 1.5, 1e-9);
  EXPECT_NEAR(values[0].limit, 5.0, 1e-9);
  EXPECT_NEAR(values[0].finest_error, 2.0 * std::pow(0.1, 1.5) / 5.0, 1e-9);
  EXPECT_NEAR(values[0].highest.back() - values[0].lowest.back(), 0.2, 1e-12);
}

struct NoLimit {
  const char* why;
  std::vector<double> values;
};
class FindNoLimit : public testing::TestWithParam<NoLimit> {};

TEST_P(FindNoLimit, WhereThereIsNothingToExtrapolate) {
  std::vector<ConvergenceRow> rows;
  double h = 0.8;
  for (const double value : GetParam().values) rows.push_back(row(h /= 2.0, not_known, value));

  const std::vector<ConvergenceValue> found = find_limits(rows, {"p.pk1.end"});

  EXPECT_TRUE(std::isnan(found[0].order));
  EXPECT_TRUE(std::isnan(found[0].limit));
  EXPECT_TRUE(std::isnan(found[0].finest_error));
}

INSTANTIATE_TEST_SUITE_P(Values, FindNoLimit,
                         testing::Values(NoLimit{"Two", {1.0, 1.5}},
                                         NoLimit{"Alternating", {1.0, 1.5, 1.2}},
                                         NoLimit{"Diverging", {1.0, 1.5, 2.5}},
                                         NoLimit{"Constant", {1.0, 1.0, 1.0}},
                                         NoLimit{"Missing", {1.0, std::nan(""), 1.5}}),
                         [](const auto& one) { return one.param.why; });

TEST(ParseVariation, SplitsAtCommasThatBelongToNoValue) {
  const Variation plain = parse_variation("kernel.support=2.1,2.6");
  const Variation nested = parse_variation("a[0].b=[1,2],{c=3,d=4},\"x,y\"");

  EXPECT_EQ(plain.key, "kernel.support");
  EXPECT_THAT(plain.values, ElementsAre("2.1", "2.6"));
  EXPECT_EQ(nested.key, "a[0].b");
  EXPECT_THAT(nested.values, ElementsAre("[1,2]", "{c=3,d=4}", "\"x,y\""));
}

TEST(ParseVariation, RefusesWhatIsNone) {
  for (const auto& [text, message] :
       {std::pair("kernel.support", "key=a,b"), std::pair("=1,2", "key=a,b"),
        std::pair("a=", "missing"), std::pair("a=1,,2", "missing"),
        std::pair("a=1,2,1", "1 stands twice")})
    EXPECT_THAT([text = text] { (void)parse_variation(text); },
                ThrowsMessage<InputError>(HasSubstr(message)));
}

}  // namespace
}  // namespace tlsph

#include "tlsph/studies/converge.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "converge_study.hpp"
#include "tlsph/io/json.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(Converge, AgainstTheExactSolutionHasOrderTwo) {
  const ConvergenceTable table =
      study(pushed_bar + with_exact, {0.00625, 0.025, 0.0125}, {"stress-point", "mirror"});

  EXPECT_EQ(table.method, ConvergenceMethod::exact);
  EXPECT_THAT(table.quantities, ElementsAre("displacement", "velocity", "stress"));
  ASSERT_EQ(table.rows.size(), 6);
  for (std::size_t k = 0; k < 6; ++k) {
    const ConvergenceRow& row = table.rows[k];
    const double spacing = 0.025 / std::pow(2.0, k % 3);
    EXPECT_EQ(row.formulation, k < 3 ? "stress-point" : "mirror");
    EXPECT_DOUBLE_EQ(row.spacing, spacing);
    EXPECT_EQ(row.particles, std::lround(1.0 / spacing) + 1);
    EXPECT_GT(row.steps, 0);
    EXPECT_EQ(row.failure, "");
    if (k % 3 == 0) continue;
    for (std::size_t q = 0; q < 3; ++q)
      EXPECT_NEAR(row.orders[q], std::log2(table.rows[k - 1].errors[q] / row.errors[q]), 1e-12);
  }
  ASSERT_EQ(table.fits.size(), 6);
  for (const ConvergenceFit& entry : table.fits)
    EXPECT_NEAR(entry.fit.order, 2.0, 0.2) << entry.series << ' ' << entry.quantity;
}

TEST_F(Converge, ComparesFurtherKeysEachWithEach) {
  ConvergenceRequest compared = request(pushed_bar + with_exact, {0.1, 0.05});
  compared.formulations = {"variational", "mirror"};
  compared.over = {{"kernel.support", {"1.8", "2.5"}}};

  const ConvergenceTable table = converge(compared, {});

  std::vector<std::string> series;
  for (const ConvergenceFit& entry : table.fits)
    if (entry.quantity == "stress") series.push_back(entry.series);
  EXPECT_THAT(series,
              ElementsAre("variational kernel.support=1.8", "variational kernel.support=2.5",
                          "mirror kernel.support=1.8", "mirror kernel.support=2.5"));
  EXPECT_THAT(table.rows[3].over, ElementsAre("2.5"));
  EXPECT_NE(table.rows[1].errors[2], table.rows[3].errors[2]);
}

TEST_F(Converge, OfSeedsHoldsTheMedianAgainstTheWorst) {
  ConvergenceRequest jittered = request(pushed_bar + with_exact, {0.05, 0.025, 0.0125},
                                        {"body.jitter=0.2", "formulation=consistent"});
  jittered.seeds = {1, 2, 3};
  ConvergenceOptions options;
  options.out = folder / "out";

  const ConvergenceTable table = converge(jittered, options);

  ASSERT_EQ(table.rows.size(), 9);
  EXPECT_TRUE(table.sampled());
  for (std::size_t k = 0; k < 3; ++k) {
    const ConvergenceLevel& level = table.levels[k];
    EXPECT_EQ(level.runs, 3);
    std::vector<double> errors;
    for (std::size_t s = 0; s < 3; ++s) {
      EXPECT_EQ(table.rows[3 * k + s].sample, std::to_string(s + 1));
      errors.push_back(table.rows[3 * k + s].errors[1]);
    }
    std::ranges::sort(errors);
    EXPECT_THAT(errors,
                ElementsAre(level.errors[1].best, level.errors[1].median, level.errors[1].worst));
    EXPECT_LT(level.errors[1].best, level.errors[1].worst);
  }
  for (const ConvergenceFit& entry : table.fits) {
    EXPECT_GE(entry.fit.order, 1.0) << entry.quantity;
    EXPECT_GE(entry.worst_fit.order, 1.0) << entry.quantity;
  }
  EXPECT_THAT(read(folder / "out/convergence.csv"),
              HasSubstr(",formulation,body.seed,displacement,"));
  EXPECT_THAT(read(folder / "out/spread.csv"), StartsWith("series,spacing,particles,runs,failed,"
                                                          "quantity,best,median,worst,"));
  const Json json = Json::read(folder / "out/convergence.json");
  EXPECT_EQ(json.list("levels")[2].number("velocity.median"), table.levels[2].errors[1].median);
  EXPECT_EQ(json.list("orders")[1].number("order_worst"), table.fits[1].worst_fit.order);
  EXPECT_THAT(table.text(), HasSubstr("consistent: velocity"));
}

// The same seed is the same body; seeds without an exact solution are compared each with itself.
TEST_F(Converge, OfSeedsByProbesComparesEachWithItself) {
  ConvergenceRequest jittered = request(pushed_bar + with_probes, {0.1, 0.05, 0.025},
                                        {"body.jitter=0.2", "formulation=consistent"});
  jittered.seeds = {4};
  ConvergenceOptions options;
  options.out = folder / "one";
  const ConvergenceTable one = converge(jittered, options);
  jittered.seeds = {7, 4};
  options.out = folder / "two";

  const ConvergenceTable two = converge(jittered, options);

  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(two.rows[2 * k + 1].errors, one.rows[k].errors);
    EXPECT_NE(two.rows[2 * k].errors, one.rows[k].errors);
  }
  EXPECT_TRUE(std::isnan(two.levels[2].errors[0].median));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "two/consistent/0.1/seed-7/probes.csv"));
}

TEST_F(Converge, WritesWhatItReturns) {
  const ConvergenceTable table = study(pushed_bar + with_exact, {0.1, 0.05});

  const std::string csv = read(folder / "out/convergence.csv");
  EXPECT_THAT(csv, StartsWith("spacing,particles,steps,dt,wall_seconds,formulation,displacement,"
                              "velocity,stress,order_displacement,order_velocity,order_stress,"
                              "failure\n0.1"));
  const Json json = Json::read(folder / "out/convergence.json");
  EXPECT_EQ(json.text("method"), "exact");
  const auto rows = json.list("rows");
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[1].number("stress"), table.rows[1].errors[2]);
  EXPECT_EQ(rows[1].number("order_stress"), table.rows[1].orders[2]);
  EXPECT_TRUE(rows[0].is_null("order_stress"));
  EXPECT_TRUE(rows[0].is_null("failure"));
  const auto orders = json.list("orders");
  ASSERT_EQ(orders.size(), 3);
  EXPECT_EQ(orders[2].text("quantity"), "stress");
  EXPECT_EQ(orders[2].number("order"), table.fits[2].fit.order);
  const std::string text = table.text();
  for (const char* part : {"stress-point\n", "spacing [m]", "fitted order"})
    EXPECT_THAT(text, HasSubstr(part));
}

// At spacing 0.025 the prescribed step is beyond the critical one (0.032/1.0 s … ), coarser runs
// hold.
TEST_F(Converge, KeepsTheRunsThatDoNotFail) {
  const std::string soft = pushed_bar + with_exact;

  const ConvergenceTable table = study(
      soft, {0.2, 0.1, 0.0125}, {},
      {"material.law=neo-hookean", "time.step=3e-3", "time.allow_unstable=true", "time.end=1"});

  ASSERT_EQ(table.rows.size(), 3);
  EXPECT_EQ(table.rows[0].failure, "");
  EXPECT_EQ(table.rows[1].failure, "");
  EXPECT_NE(table.rows[2].failure, "");
  EXPECT_TRUE(std::isnan(table.rows[2].errors[0]));
  EXPECT_EQ(table.fits[0].fit.points, 2);
  EXPECT_THAT(table.text(), HasSubstr("failed: " + table.rows[2].failure));
}

TEST_F(Converge, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  ConvergenceOptions options;
  options.out = folder / "out";
  options.stop_requested = &stop;

  const ConvergenceTable table = converge(request(pushed_bar + with_exact, {0.1, 0.05}), options);

  EXPECT_TRUE(table.interrupted);
  EXPECT_TRUE(table.rows.empty());
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "out/convergence.csv"));
}

}  // namespace
}  // namespace tlsph

#include "tlsph/studies/converge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study_folder.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

class Converge : public StudyFolder {
 protected:
  ConvergenceRequest request(const std::string& scene, std::vector<double> spacings,
                             std::vector<std::string> overrides = {}) const {
    ConvergenceRequest request;
    request.scene = write("scene.toml", scene);
    request.overrides = std::move(overrides);
    request.spacings = std::move(spacings);
    return request;
  }
  ConvergenceTable study(const std::string& scene, std::vector<double> spacings,
                         std::vector<std::string> formulations = {},
                         std::vector<std::string> overrides = {}) {
    ConvergenceOptions options;
    options.out = folder_ / "out";
    options.threads = 1;
    ConvergenceRequest asked = request(scene, std::move(spacings), std::move(overrides));
    asked.formulations = std::move(formulations);
    return converge(asked, options);
  }
};

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
  options.out = folder_ / "out";

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
  EXPECT_THAT(read(folder_ / "out/convergence.csv"),
              HasSubstr(",formulation,body.seed,displacement,"));
  EXPECT_THAT(read(folder_ / "out/spread.csv"), StartsWith("series,spacing,particles,runs,failed,"
                                                           "quantity,best,median,worst,"));
  const Json json = Json::read(folder_ / "out/convergence.json");
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
  options.out = folder_ / "one";
  const ConvergenceTable one = converge(jittered, options);
  jittered.seeds = {7, 4};
  options.out = folder_ / "two";

  const ConvergenceTable two = converge(jittered, options);

  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(two.rows[2 * k + 1].errors, one.rows[k].errors);
    EXPECT_NE(two.rows[2 * k].errors, one.rows[k].errors);
  }
  EXPECT_TRUE(std::isnan(two.levels[2].errors[0].median));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "two/consistent/0.1/seed-7/probes.csv"));
}

TEST_F(Converge, OfProbesComparesNeighbouringRuns) {
  const ConvergenceTable table = study(pushed_bar + with_probes, {0.1, 0.05, 0.025, 0.0125});

  EXPECT_EQ(table.method, ConvergenceMethod::probes);
  EXPECT_THAT(table.quantities, ElementsAre("displacement", "pk1"));
  ASSERT_EQ(table.rows.size(), 4);
  for (std::size_t q = 0; q < 2; ++q) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(table.rows[k].errors[q], 0.0);
    EXPECT_TRUE(std::isnan(table.rows[3].errors[q]));
    EXPECT_TRUE(std::isnan(table.rows[1].orders[q]));
    EXPECT_NEAR(table.rows[3].orders[q], 2.0, 0.2);
    EXPECT_NEAR(table.fits[q].fit.order, 2.0, 0.2);
    EXPECT_EQ(table.fits[q].fit.points, 3);
    EXPECT_NEAR(table.fits[q].finest_error,
                table.rows[2].errors[q] / (std::pow(2.0, table.fits[q].fit.order) - 1.0), 1e-12);
  }
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "out/stress-point/0.0125/probes.csv"));
}

// Probes on the exact solution too: what Richardson says is left must be what is left.
TEST_F(Converge, OfProbesEstimatesTheErrorThatIsLeft) {
  const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  const ConvergenceTable table = study(pushed_bar + tip, {0.05, 0.025, 0.0125});
  RunOptions options;
  options.out = folder_ / "exact";
  (void)run(read_scene(write("exact.toml", pushed_bar + tip + with_exact), {"body.spacing=0.0125"}),
            options);

  const History computed = read_history(options.out / "probes.csv");
  const History exact = read_history(options.out / "probes_exact.csv");
  std::vector<double> difference = computed.values[0];
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= exact.values[0][k];
  const double left =
      std::sqrt(squared_norm(exact.time, difference) / squared_norm(exact.time, exact.values[0]));

  EXPECT_NEAR(table.fits[0].finest_error / left, 1.0, 0.1);
}

// A bar that rings freely: c = √(E/ρ), period 4 L/c of the first mode.
TEST_F(Converge, ExtrapolatesWhatItReadsOffTheProbes) {
  const std::string ringing =
      "dimension = 1\n[body]\nshape = { interval = [0.0, 1.0] }\nspacing = 0.1\n[material]\nlaw = "
      "\"linear-elastic\"\nassumption = \"stress\"\nyoung = 1e6\npoisson = 0.0\ndensity = 1000\n"
      "[[boundary]]\nwhere = \"left\"\nfixed = true\n[[boundary]]\nwhere = \"right\"\n"
      "traction = { curve = \"sine-squared\", amplitude = 1e3, duration = 0.12 }\n"
      "[time]\nend = 0.6\n"
      "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  ConvergenceRequest read_off = request(ringing, {0.1, 0.05, 0.025});
  ConvergenceOptions options;
  options.out = folder_ / "out";

  const ConvergenceTable chosen = converge(read_off, options);
  read_off.values = {"tip.displacement_x.period", "tip.displacement_x.end"};
  const ConvergenceTable asked = converge(read_off, options);

  EXPECT_THAT(chosen.value_names, testing::Contains("tip.displacement_x.peak"));
  EXPECT_THAT(asked.value_names,
              ElementsAre("tip.displacement_x.period", "tip.displacement_x.end"));
  ASSERT_EQ(asked.values.size(), 2);
  const double finest = asked.values[1].medians.back();
  EXPECT_EQ(finest, read_history(folder_ / "out/stress-point/0.025/probes.csv").values[0].back());
  EXPECT_EQ(asked.rows[2].values[1], finest);
  EXPECT_THAT(asked.text(), HasSubstr("tip.displacement_x.period"));
}

// Errors of one sign and one order: the extrapolated history is nearer to the exact one than the
// finest run is, by far.
TEST_F(Converge, ExtrapolatesHistories) {
  const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  RunOptions exact;
  exact.out = folder_ / "exact";
  (void)run(read_scene(write("exact.toml", pushed_bar + tip + with_exact), {"body.spacing=0.0125"}),
            exact);

  (void)study(pushed_bar + tip, {0.05, 0.025, 0.0125});

  const auto error = [&](const std::filesystem::path& file) {
    const History truth = read_history(exact.out / "probes_exact.csv");
    History history = read_history(file);
    for (std::size_t k = 0; k < history.time.size(); ++k)
      history.values[0][k] -= truth.values[0][k];
    return std::sqrt(squared_norm(history.time, history.values[0]));
  };
  EXPECT_LT(error(folder_ / "out/stress-point/probes_extrapolated.csv"),
            0.2 * error(folder_ / "out/stress-point/0.0125/probes.csv"));
}

TEST_F(Converge, WritesWhatItReturns) {
  const ConvergenceTable table = study(pushed_bar + with_exact, {0.1, 0.05});

  const std::string csv = read(folder_ / "out/convergence.csv");
  EXPECT_THAT(csv, StartsWith("spacing,particles,steps,dt,wall_seconds,formulation,displacement,"
                              "velocity,stress,order_displacement,order_velocity,order_stress,"
                              "failure\n0.1"));
  const Json json = Json::read(folder_ / "out/convergence.json");
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
      soft, {0.2, 0.1, 0.0125}, {}, {"material.law=neo-hookean", "time.step=3e-3", "time.end=1"});

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
  options.out = folder_ / "out";
  options.stop_requested = &stop;

  const ConvergenceTable table = converge(request(pushed_bar + with_exact, {0.1, 0.05}), options);

  EXPECT_TRUE(table.interrupted);
  EXPECT_TRUE(table.rows.empty());
  EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "out/convergence.csv"));
}

struct Refusal {
  std::string scene;
  std::vector<double> spacings;
  std::vector<std::string> formulations;
  std::string message;
};

TEST_F(Converge, RefusesWhatIsNoStudy) {
  const std::string exact = pushed_bar + with_exact;
  for (const Refusal& refusal : std::vector<Refusal>{
           {exact, {}, {}, "--spacing: 0 given; at least 2"},
           {exact, {0.1}, {}, "--spacing: 1 given; at least 2"},
           {pushed_bar + with_probes, {0.1, 0.05}, {}, "--spacing: 2 given; at least 3"},
           {pushed_bar, {0.1, 0.05, 0.025}, {}, "nothing to compare"},
           {exact, {0.1, 0.05, 0.1}, {}, "--spacing: 0.1 stands twice"},
           {exact, {0.1, 0.0}, {}, "--spacing: 0 is no spacing"},
           {exact, {0.1, -0.1}, {}, "--spacing: -0.1 is no spacing"},
           {exact, {0.1, std::nan("")}, {}, "is no spacing"},
           {exact, {0.1, 0.05, 0.0502}, {}, "divides the body like"},
           {exact, {0.1, 0.03}, {}, "spacing"},
           {exact, {0.1, 0.05}, {"mirror", "mirror"}, "--formulation: mirror stands twice"},
           {exact, {0.1, 0.05}, {"mirrors"}, "--formulation: there is no \"mirrors\""},
           {pushed_bar + "[[probe]]\nat = [2.0]\n", {0.1, 0.05, 0.025}, {}, "probe"}}) {
    EXPECT_THAT([&] { (void)study(refusal.scene, refusal.spacings, refusal.formulations); },
                ThrowsMessage<InputError>(HasSubstr(refusal.message)));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << refusal.message;
  }
}

TEST_F(Converge, RefusesVariationsThatAreNone) {
  const ConvergenceRequest sound = request(pushed_bar + with_exact, {0.1, 0.05});
  const auto refuses = [&](auto change, const std::string& message) {
    ConvergenceRequest unsound = sound;
    change(unsound);
    EXPECT_THAT([&] { (void)converge(unsound, {}); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };

  refuses([](auto& r) { r.over = {{"body.spacing", {"1", "2"}}}; }, "has an option, --spacing");
  refuses([](auto& r) { r.over = {{"body.seed", {"1", "2"}}}; }, "has an option, --seed");
  refuses([](auto& r) { r.over = {{"no.such", {"1"}}}; }, "no");
  refuses([](auto& r) { r.over = {{"kernel.support", {"2", "0"}}}; }, "support");
  refuses([](auto& r) { r.over = {{"a", {"1"}}, {"a", {"1"}}}; }, "stands twice");
  refuses([](auto& r) { r.over = {{"reference.exact", {"none", "bar-wave"}}}; }, "nothing to");
  refuses([](auto& r) { r.seeds = {1, 2}; }, "--seed: the particles do not depend on it");
  refuses([](auto& r) { r.seeds = {1, 1}; }, "--seed: 1 stands twice");
  refuses([](auto& r) { r.clouds = {"a.csv", "b.csv"}; }, "--cloud: a cloud has its spacing");
  refuses([](auto& r) { r.values = {"tip.displacement_x.mean"}; }, "--value: ");
  refuses([](auto& r) { r.values = {"tip.displacement_x.end"}; }, "no probe records");
}

}  // namespace
}  // namespace tlsph

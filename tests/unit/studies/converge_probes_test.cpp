/// Convergence studies without an exact solution: neighbouring runs are compared at the probes.
#include <gmock/gmock.h>

#include <cmath>

#include "converge_study.hpp"
#include "read_history.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ConvergeOfProbes : public Converge {};

TEST_F(ConvergeOfProbes, ComparesNeighbouringRuns) {
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
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "out/stress-point/0.0125/probes.csv"));
}

// Probes on the exact solution too: what Richardson says is left must be what is left.
TEST_F(ConvergeOfProbes, EstimatesTheErrorThatIsLeft) {
  const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  const ConvergenceTable table = study(pushed_bar + tip, {0.05, 0.025, 0.0125});
  RunOptions options;
  options.out = folder / "exact";
  (void)run(read_scene(write("exact.toml", pushed_bar + tip + with_exact), {"body.spacing=0.0125"}),
            options);

  const History computed = test::read_history(options.out / "probes.csv");
  const History exact = test::read_history(options.out / "probes_exact.csv");
  std::vector<double> difference = computed.values[0];
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= exact.values[0][k];
  const double left =
      std::sqrt(squared_norm(exact.time, difference) / squared_norm(exact.time, exact.values[0]));

  EXPECT_NEAR(table.fits[0].finest_error / left, 1.0, 0.1);
}

// A bar that rings freely: c = √(E/ρ), period 4 L/c of the first mode.
TEST_F(ConvergeOfProbes, ExtrapolatesWhatItReadsOffTheProbes) {
  const std::string ringing =
      "dimension = 1\n[body]\nshape = { interval = [0.0, 1.0] }\nspacing = 0.1\n[material]\nlaw = "
      "\"linear-elastic\"\nassumption = \"stress\"\nyoung = 1e6\npoisson = 0.0\ndensity = 1000\n"
      "[[boundary]]\nwhere = \"left\"\nfixed = true\n[[boundary]]\nwhere = \"right\"\n"
      "traction = { curve = \"sine-squared\", amplitude = 1e3, duration = 0.12 }\n"
      "[time]\nend = 0.6\n"
      "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  ConvergenceRequest read_off = request(ringing, {0.1, 0.05, 0.025});
  ConvergenceOptions options;
  options.out = folder / "out";

  const ConvergenceTable chosen = converge(read_off, options);
  read_off.values = {"tip.displacement_x.period", "tip.displacement_x.end"};
  const ConvergenceTable asked = converge(read_off, options);

  EXPECT_THAT(chosen.value_names, testing::Contains("tip.displacement_x.peak"));
  EXPECT_THAT(asked.value_names,
              ElementsAre("tip.displacement_x.period", "tip.displacement_x.end"));
  ASSERT_EQ(asked.values.size(), 2);
  const double finest = asked.values[1].medians.back();
  EXPECT_EQ(finest,
            test::read_history(folder / "out/stress-point/0.025/probes.csv").values[0].back());
  EXPECT_EQ(asked.rows[2].values[1], finest);
  EXPECT_THAT(asked.text(), HasSubstr("tip.displacement_x.period"));
}

// Errors of one sign and one order: the extrapolated history is nearer to the exact one than the
// finest run is, by far.
TEST_F(ConvergeOfProbes, ExtrapolatesHistories) {
  const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  RunOptions exact;
  exact.out = folder / "exact";
  (void)run(read_scene(write("exact.toml", pushed_bar + tip + with_exact), {"body.spacing=0.0125"}),
            exact);

  (void)study(pushed_bar + tip, {0.05, 0.025, 0.0125});

  const auto error = [&](const std::filesystem::path& file) {
    const History truth = test::read_history(exact.out / "probes_exact.csv");
    History history = test::read_history(file);
    for (std::size_t k = 0; k < history.time.size(); ++k)
      history.values[0][k] -= truth.values[0][k];
    return std::sqrt(squared_norm(history.time, history.values[0]));
  };
  EXPECT_LT(error(folder / "out/stress-point/probes_extrapolated.csv"),
            0.2 * error(folder / "out/stress-point/0.0125/probes.csv"));
}

}  // namespace
}  // namespace tlsph

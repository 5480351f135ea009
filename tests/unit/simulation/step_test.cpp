/// The time step of a run: what it keeps, what it refuses, and where a run ends that grows.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>

#include "tlsph/core/error.hpp"
#include "tlsph/io/hdf5.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("tlsph-step-" + std::to_string(::getpid()));

class StepOfARun : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder); }
};

RunOptions quiet() {
  RunOptions options;
  options.threads = 1;
  options.out = folder;
  return options;
}

/// The NumericalError of a run, which has one.
NumericalError failure_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)run(read_scene_text(text, "scene.toml", overrides), quiet());
  } catch (const NumericalError& failure) {
    return failure;
  }
  ADD_FAILURE() << "the run came to its end";
  return {"", 0.0, -1};
}

std::vector<double> series(const std::string& name) {
  return Hdf5File::open_read_only(folder / "run.h5").read_doubles("/series/" + name).values;
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

struct Moving {
  const char* name;
  const char* shape;
  double spacing, poisson;
  const char* boundary;
  const char* velocity;
  double period;  ///< [s], of its slowest vibration or turn, about
  bool bends;     ///< and does not turn
};

const std::vector<Moving> bodies = {
    {"column", "{ box = [[-0.5, 0.0], [0.5, 6.0]] }", 0.5, 0.45,
     "[[boundary]]\nwhere = \"bottom\"\nfixed = true", "[[0.0, 1.6666666666666667], [0.0, 0.0]]",
     2.0, true},
    {"ring",
     "{ difference = [{ disc = { centre = [0.0, 0.0], radius = 1.0 } }, { disc = { centre = [0.0, "
     "0.0], radius = 0.5 } }] }",
     0.1, 0.3, "", "[[2.0, -5.0], [5.0, -2.0]]", 0.05, false},
    {"L", "{ polygon = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]] }",
     0.25, 0.3, "", "[[0.0, -6.0], [2.0, 0.0]]", 0.06, false},
    {"square", "{ box = [[-0.5, -0.5], [0.5, 0.5]] }", 0.125, 0.3, "", "[[3.0, -8.0], [8.0, -3.0]]",
     0.015, false}};

/// Formulations whose divergence is the adjoint of their gradient, with the stabiliser that keeps
/// energy.
const std::vector<std::vector<std::string>> formulations = {
    {"formulation=stress-point"},
    {"formulation=variational"},
    {"formulation=consistent", "stabiliser.as=stiffness"}};

/// Vibrations and turns a body is followed through; 100 with TLSPH_ENERGY_PERIODS=100.
double periods() {
  const char* asked = std::getenv("TLSPH_ENERGY_PERIODS");
  return asked == nullptr ? 10.0 : std::atof(asked);
}

Scene moving(const Moving& body, const std::vector<std::string>& overrides) {
  const std::string text = std::string("dimension = 2\n[body]\nshape = ") + body.shape +
                           "\nspacing = " + std::to_string(body.spacing) +
                           "\n[material]\nyoung = 17e6\npoisson = " + std::to_string(body.poisson) +
                           "\ndensity = 1100\n" + body.boundary +
                           "\n[initial]\nvelocity = { gradient = " + body.velocity +
                           " }\n[time]\nend = " + std::to_string(periods() * body.period) +
                           "\n[output]\nframes = 0\nenergy_every = 1\n";
  return read_scene_text(text, "moving.toml", overrides);
}

/// Largest deviation of the balance, and how far its mean moves from the first tenth of a run to
/// the last, both of the largest energy.
struct Balanced {
  Summary summary;
  double deviation = 0.0, trend = 0.0, last_dt = 0.0;
  long rises = 0;  ///< of the step
};

Balanced balanced(const Scene& scene) {
  std::filesystem::remove_all(folder);
  Balanced result{run(scene, quiet())};
  std::vector<double> energy = series("kinetic");
  const std::vector<double> elastic = series("elastic");
  const std::vector<double> work = series("external_work");
  const std::vector<double> dissipated = series("dissipated");
  double largest = 0.0;
  for (std::size_t k = 0; k < energy.size(); ++k) {
    energy[k] += elastic[k];
    largest = std::max(largest, std::abs(energy[k]));
    energy[k] += dissipated[k] - work[k];
  }
  const double start = energy.front();
  for (double& value : energy) {
    value = (value - start) / largest;
    result.deviation = std::max(result.deviation, std::abs(value));
  }
  const std::span<const double> all(energy);
  result.trend = std::abs(mean(all.last(all.size() / 10)) - mean(all.first(all.size() / 10)));
  const std::vector<double> dt = series("dt");
  for (std::size_t k = 1; k < dt.size(); ++k) result.rises += dt[k] > 1.0001 * dt[k - 1] ? 1 : 0;
  result.last_dt = dt.back();
  return result;
}

TEST_F(StepOfARun, KeepsTheEnergyOfBodiesThatTurnAndSwing) {
  for (const Moving& body : bodies)
    for (const std::vector<std::string>& formulation : formulations) {
      SCOPED_TRACE(body.name + std::string(", ") + formulation.front());

      const Balanced run = balanced(moving(body, formulation));

      EXPECT_EQ(run.rises, 0);
      EXPECT_LE(run.trend, 1e-4);
      EXPECT_LE(run.summary.linear_momentum_drift, 1e-12);
      EXPECT_LE(run.summary.angular_momentum_drift, 1e-12);
      // At most what equal steps make that are as short as the last ones.
      std::vector<std::string> equal = formulation;
      equal.push_back(fmt::format("time.step={:.17g}", run.last_dt));
      const Balanced fixed = balanced(moving(body, equal));
      // A notch may come late in a short run, so that one of equal steps has hardly deviated yet.
      const double short_run = body.bends || periods() < 100.0 ? 1e-4 : 0.0;
      EXPECT_LE(run.deviation, std::max(short_run, body.bends ? 0.0 : 1.1 * fixed.deviation));
      EXPECT_LE(run.summary.steps, fixed.summary.steps + 1);
    }
}

/// The smallest limit on the way, from estimates at every twentieth step.
TEST_F(StepOfARun, OwesNoMoreThanATwentiethToTheSmallestLimit) {
  for (const Moving& body : {bodies.front(), bodies.back()}) {
    const std::vector<std::string> end = {fmt::format("time.end={}", 2.0 * body.period)};
    const Scene scene = moving(body, end);
    const double dt = balanced(scene).last_dt;
    const auto discretisation = build<2>(scene);
    InitialState<2> initial = build_initial<2>(scene, discretisation);
    State<2> state = make_state<2>(discretisation, initial.displacement, initial.velocity);
    evaluate<2>(discretisation, state);
    start<2>(discretisation, state, dt);
    double smallest = critical_step<2>(discretisation, state).dt;

    while (state.time < scene.time.end) {
      advance<2>(discretisation, state, dt, state.time + dt);
      evaluate<2>(discretisation, state);
      if (state.step % 20 == 0)
        smallest = std::min(smallest, critical_step<2>(discretisation, state).dt);
    }

    EXPECT_GE(dt, 0.9 * smallest / 1.05) << body.name;
    EXPECT_LE(dt, 0.93 * smallest) << body.name;
  }
}

const std::string struck_bar = R"(
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.01
[material]
law = "linear-elastic"
assumption = "stress"
young = 1e6
poisson = 0.3
density = 1000.0
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "constant", amplitude = 100.0 }
[[probe]]
name = "end"
at = [1.0]
[time]
end = 0.1
step = 3.4e-4
)";

TEST_F(StepOfARun, RefusesAStepAboveTheCriticalOne) {
  const Scene scene = read_scene_text(struck_bar, "bar.toml", {});
  try {
    (void)run(scene, quiet());
    FAIL() << "the run came to its end";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bar.toml:23:8: time.step: 0.00034 s exceeds the critical "
                                        "step of this body, 0.0003161"));
    EXPECT_THAT(error.what(), HasSubstr("time.allow_unstable = true"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder));
  EXPECT_THROW((void)plan(scene), InputError);
}

TEST_F(StepOfARun, TakesAStepAtTheCriticalOne) {
  const Summary summary =
      run(read_scene_text(struck_bar, "bar.toml", {"time.step=3.16e-4"}), quiet());
  EXPECT_NEAR(summary.end_time, 0.1, 1e-12);
}

TEST_F(StepOfARun, EndsWhereMotionStartsToGrow) {
  const NumericalError failure = failure_of(struck_bar, {"time.allow_unstable=true"});

  EXPECT_THAT(failure.what(), HasSubstr("motion grows beyond all bounds at t = "));
  EXPECT_GT(failure.time(), 0.0);
  EXPECT_LT(failure.time(), 0.02);
  EXPECT_GE(failure.particle(), 0);
  // The last frame is within the balance: the bar is drawn by 0.1 mm, or 0.2 mm on its way there.
  const Hdf5File file = Hdf5File::open_read_only(folder / "run.h5");
  const auto times = file.read_doubles("/frames/time").values;
  EXPECT_LE(times.back(), failure.time());
  const auto u = file.read_doubles("/frames/displacement").values;
  for (const double value : u) EXPECT_LT(std::abs(value), 1e-3);
}

TEST_F(StepOfARun, RefusesStepsThatCannotBeCounted) {
  for (const auto& [end, count] : {std::pair{"1e25", "e+28 steps"}, std::pair{"1e300", "e+"}}) {
    const std::vector<std::string> endless = {"time.step=2e-4", std::string("time.end=") + end};
    EXPECT_THAT([&] { (void)run(read_scene_text(struck_bar, "bar.toml", endless), quiet()); },
                testing::ThrowsMessage<InputError>(
                    testing::AllOf(HasSubstr("time.end"), HasSubstr(count))));
    EXPECT_FALSE(std::filesystem::exists(folder));
  }
}

TEST_F(StepOfARun, EndsWhereItsStepCollapses) {
  const std::string crushed = R"(
dimension = 1
formulation = "mirror"
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.25
[material]
law = "st-venant-kirchhoff"
young = 1.0
poisson = 0.3
density = 1.0
[time]
end = 100
safety = 0.95
[initial]
velocity = { gradient = [[-2]] }
)";
  const NumericalError failure = failure_of(crushed);

  EXPECT_THAT(failure.what(), HasSubstr("the time step collapsed"));
  EXPECT_GT(failure.time(), 0.4);
  EXPECT_LT(failure.time(), 1.0);
  EXPECT_GE(failure.particle(), 0);
}

/// A pulse of 0.6 E that rises within a step and a half of the critical one.
TEST_F(StepOfARun, KnowsTheFirstLoads) {
  for (const char* safety : {"0.95", "0.9", "0.8", "0.7"}) {
    std::filesystem::remove_all(folder);
    const Summary summary =
        run(read_scene_text(R"(
dimension = 1
formulation = "variational"
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.016666666666666666
[kernel]
support = 3.1
correction = "gradient"
[stabiliser]
kind = "none"
[material]
assumption = "stress"
young = 1e6
poisson = 0.3
density = 1000.0
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "pulse", amplitude = -6e5, rise = 6.033e-4, duration = 6.033e-3 }
[time]
end = 0.1
)",
                            "pulse.toml", {std::string("time.safety=") + safety}),
            quiet());
    EXPECT_NEAR(summary.end_time, 0.1, 1e-12) << safety;
    EXPECT_LT(summary.energy.drift_relative, 0.05) << safety;
  }
}

TEST_F(StepOfARun, WritesNoRowOfALostState) {
  const NumericalError failure = failure_of(R"(
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "ramp", amplitude = -1.5, rise = 0.02 } }
[[probe]]
name = "middle"
at = [0.5]
record = ["displacement", "cauchy"]
[time]
end = 0.02
step = 5e-4
)");
  std::ifstream rows(folder / "probes.csv");
  std::string line;
  std::string last;
  std::getline(rows, line);
  while (std::getline(rows, line)) {
    EXPECT_THAT(line, testing::Not(HasSubstr("nan")));
    last = line;
  }
  EXPECT_LT(std::stod(last), failure.time());
}

TEST_F(StepOfARun, EndsWhereItsEnergyIsNoNumber) {
  const NumericalError failure = failure_of(R"(
dimension = 2
[body]
shape = { box = [[0.0, 0.0], [1.0, 1.0]] }
spacing = 0.25
[material]
young = 1.0
poisson = 0.3
density = 1.0
[initial]
velocity = { gradient = [[1e200, 0.0], [0.0, 0.0]] }
[time]
end = 0.1
step = 0.01
)");
  EXPECT_GE(failure.particle(), 0);
  EXPECT_THAT(failure.what(), HasSubstr(" at t = "));
}

TEST_F(StepOfARun, EndsAtTheToleranceOfItsEnergy) {
  const NumericalError failure = [] {
    try {
      (void)run(moving(bodies.front(), {"time.energy_tolerance=1e-6"}), quiet());
    } catch (const NumericalError& error) {
      return error;
    }
    return NumericalError("", 0.0, -1);
  }();
  EXPECT_THAT(failure.what(), HasSubstr("energy left its balance by"));
  EXPECT_GT(failure.time(), 0.0);
  EXPECT_GE(failure.particle(), 0);
}

}  // namespace
}  // namespace tlsph

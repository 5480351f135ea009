/// A run that goes on from its checkpoint ends in the same bits as one that was never interrupted.

#include <unistd.h>

#include <atomic>
#include <cstring>
#include <filesystem>

#include "property/bodies.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/io/hdf5.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph::property {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string name;
  std::string text;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}

std::string rest_of_scene(double end, const std::string& law = "neo-hookean") {
  return R"(
[material]
law = ")" +
         law +
         R"("
young = 2e6
poisson = 0.3
density = 1000
[[probe]]
at = )" + std::string(end > 0.1 ? "[0.05, 0.05]" : "[0.11]") +
         R"(
record = ["displacement", "cauchy"]
[time]
end = )" +
         std::to_string(end) + R"(
[output]
frames = 7
probe_every = 3
energy_every = 4
checkpoint_steps = 60
)";
}

/// Large strains, so that the step is estimated anew on the way.
std::vector<Case> cases() {
  const std::string sheet = R"(
[body]
shape = { box = [[0.0, 0.0], [0.2, 0.1]] }
spacing = 0.02
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "smooth-ramp", amplitude = 0.06, rise = 9e-2 } }
[[boundary]]
where = "top"
traction = { curve = "pulse", amplitude = -2e4, rise = 1e-2, duration = 2e-2 }
)";
  const std::string bar = R"(
[body]
shape = { interval = [0.0, 0.4] }
spacing = 0.01
[[boundary]]
where = "left"
traction = { curve = "pulse", amplitude = -2e5, rise = 1e-3, duration = 4e-3 }
[[boundary]]
where = "right"
fixed = true
)";
  return {
      {"stress_point", sheet + rest_of_scene(0.12)},
      {"linear", sheet + rest_of_scene(0.12, "linear-elastic")},
      {"variational", "formulation = \"variational\"\n" + sheet + rest_of_scene(0.12)},
      {"consistent", "formulation = \"consistent\"\n" + sheet + rest_of_scene(0.12)},
      {"damped", "formulation = \"variational\"\n" + sheet +
                     "[stabiliser]\nkind = \"pair\"\nas = \"viscosity\"\n" + rest_of_scene(0.12)},
      {"mirror", "dimension = 1\nformulation = \"mirror\"\n" + bar + rest_of_scene(0.03)},
      {"thesis", "dimension = 1\nformulation = \"thesis\"\n" + bar + rest_of_scene(0.03)},
  };
}

class Resume : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    directory = fs::temp_directory_path() /
                ("tlsph_resume_" + GetParam().name + '_' + std::to_string(::getpid()));
    fs::remove_all(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  [[nodiscard]] RunOptions options(const char* name) const {
    RunOptions result;
    result.out = directory / name;
    result.threads = 1;
    return result;
  }
  static Scene scene() { return read_scene_text(GetParam().text, GetParam().name); }

  fs::path directory;
};

/// Every number of both files, compared as bits.
void expect_same_bits(const fs::path& one, const fs::path& other) {
  const auto a = Hdf5File::open_read_only(one);
  const auto b = Hdf5File::open_read_only(other);
  int compared = 0;
  for (const std::string group : {"/frames", "/series"}) {
    ASSERT_EQ(a.names(group), b.names(group));
    for (const std::string& name : a.names(group)) {
      std::string item = group;
      item.append("/").append(name);
      const auto x = a.read_doubles(item);
      const auto y = b.read_doubles(item);
      ASSERT_EQ(x.shape, y.shape) << item;
      ASSERT_FALSE(x.values.empty());
      EXPECT_EQ(std::memcmp(x.values.data(), y.values.data(), x.values.size() * sizeof(double)), 0)
          << item;
      ++compared;
    }
  }
  EXPECT_GE(compared, 8);
}

/// The checkpoint left in the middle of a whole run is where the second run starts again.
TEST_P(Resume, FromACheckpointOnTheWayEndsInTheSameBits) {
  RunOptions whole = options("whole");
  const Summary first = run(scene(), whole);
  fs::copy(directory / "whole", directory / "again", fs::copy_options::recursive);
  ASSERT_GT(first.steps, 61);
  ASSERT_NE(first.steps % 60, 0);

  RunOptions again = options("again");
  again.resume = true;
  const Summary second = run(scene(), again);

  EXPECT_EQ(second.steps, first.steps);
  EXPECT_EQ(second.energy.drift_relative, first.energy.drift_relative);
  EXPECT_EQ(second.energy.external_work, first.energy.external_work);
  EXPECT_EQ(second.linear_momentum_drift, first.linear_momentum_drift);
  expect_same_bits(directory / "whole/run.h5", directory / "again/run.h5");
}

/// A run that was asked to stop before its first step, and then to go on.
TEST_P(Resume, AfterAnInterruptionEndsInTheSameBits) {
  run(scene(), options("whole"));
  std::atomic<bool> stop{true};
  RunOptions stopped = options("stopped");
  stopped.stop_requested = &stop;
  const Summary interrupted = run(scene(), stopped);
  ASSERT_TRUE(interrupted.interrupted);

  stopped.stop_requested = nullptr;
  stopped.resume = true;
  const Summary second = run(scene(), stopped);

  EXPECT_FALSE(second.interrupted);
  expect_same_bits(directory / "whole/run.h5", directory / "stopped/run.h5");
}

TEST_P(Resume, OfAnotherSceneIsRefused) {
  run(scene(), options("whole"));
  RunOptions again = options("whole");
  again.resume = true;

  EXPECT_THROW(
      run(read_scene_text(GetParam().text, GetParam().name, {"material.poisson=0.31"}), again),
      InputError);
}

/// Two steppers that go on from copies of one state, which the original's steps do not touch.
TEST_P(Resume, CopiesOfAStateGoOnInTheSameBits) {
  const Scene scene = Resume::scene();
  in_dimension(scene.dimension, [&]<int D>() {
    const Discretisation<D> body = build<D>(scene);
    InitialState<D> initial = build_initial<D>(scene, body);
    State<D> original = make_state<D>(body, initial.displacement, initial.velocity);
    const auto march = [&](State<D>& state, int steps) {
      constexpr double dt = 5e-5;
      for (int n = 0; n < steps; ++n) {
        evaluate<D>(body, state);
        if (state.step == 0) start<D>(body, state, dt);
        advance<D>(body, state, dt, static_cast<double>(state.step + 1) * dt);
      }
    };
    march(original, 40);
    State<D> copy = original;
    march(original, 40);
    ASSERT_EQ(copy.step, 40);
    ASSERT_FALSE(copy.u.isApprox(original.u, 1e-9));
    march(copy, 40);
    EXPECT_TRUE((copy.u.array() == original.u.array()).all());
    EXPECT_TRUE((copy.v.array() == original.v.array()).all());
    EXPECT_TRUE((copy.P.array() == original.P.array()).all());
  });
}

INSTANTIATE_TEST_SUITE_P(, Resume, testing::ValuesIn(cases()), ByName());

}  // namespace
}  // namespace tlsph::property

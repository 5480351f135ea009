/// A step takes nothing from the heap, counted below the C++ and the C allocator.

#include <gtest/gtest.h>
#include <omp.h>

#include "counting_allocator.hpp"
#include "property/bodies.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/dynamics/partial_evaluation.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/sweep/sweep.hpp"

#ifdef TLSPH_COUNTS_ALLOCATIONS

namespace tlsph::property {
namespace {

struct Case {
  std::string name;
  std::string text;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}

const std::string tail = R"(
[material]
law = "neo-hookean"
young = 2e6
poisson = 0.3
density = 1000
[time]
end = 1.0
)";

const std::string linear = R"(
[material]
law = "linear-elastic"
young = 2e6
poisson = 0.3
density = 1000
[time]
end = 1.0
)";

const std::string regions = R"(
[material]
young = 2e6
poisson = 0.3
density = 1000
[[material.region]]
box = [[0.0, 0.0], [0.1, 0.1]]
law = "linear-elastic"
density = 2000
[time]
end = 1.0
)";

std::vector<Case> cases() {
  const std::string bar = R"(
[body]
shape = { interval = [0.0, 0.4] }
spacing = 0.01
[[boundary]]
where = "left"
traction = { curve = "pulse", amplitude = -2e3, rise = 1e-3, duration = 4e-3 }
[[boundary]]
where = "right"
displacement = { x = { curve = "table", time = [0.0, 0.1, 0.2], value = [0.0, 1e-4, 0.0] } }
)";
  const std::string body = R"(
[body]
shape = { box = [[0.0, 0.0], [0.2, 0.1]] }
spacing = 0.01
)";
  const std::string sheet = "gravity = [0.0, -9.81]\n" + body + R"(
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { y = { curve = "sine-squared", amplitude = 1e-3, duration = 1e-2 } }
[[boundary]]
where = "top"
traction = { curve = "smooth-ramp", amplitude = [1e3, -2e3], rise = 1e-3 }
)";
  const std::string strip = body + R"(
[[boundary]]
where = "left"
traction = { curve = "pulse", amplitude = -2e3, rise = 1e-3, duration = 4e-3 }
[[boundary]]
where = "right"
displacement = { x = { curve = "ramp", amplitude = 1e-4, rise = 1e-2 } }
[[boundary]]
where = "top"
symmetry = true
[[boundary]]
where = "bottom"
symmetry = true
)";
  const auto named = [](const char* formulation) {
    return "formulation = \"" + std::string(formulation) + "\"\n";
  };
  const std::string pair = "[stabiliser]\nkind = \"pair\"\n";
  const std::string damped = pair + "as = \"viscosity\"\n";
  const std::string wide = "[kernel]\nsupport = 2.1\n";
  const std::string d1 = "dimension = 1\n";
  return {
      {"bar_stress_point", d1 + named("stress-point") + bar + tail},
      {"bar_stress_point_wide", d1 + named("stress-point") + bar + wide + pair + tail},
      {"bar_variational", d1 + named("variational") + bar + damped + tail},
      {"bar_mirror", d1 + named("mirror") + bar + tail},
      {"bar_thesis", d1 + named("thesis") + bar + tail},
      {"bar_thesis_as_printed",
       d1 + named("thesis") + "boundary_treatment = \"as-printed\"\n" + bar + tail},
      {"bar_thesis_eta", d1 + named("thesis") + "boundary_treatment = \"eta\"\n" + bar + tail},
      {"bar_thesis_umfpack", d1 + named("thesis") + "boundary_solver = \"umfpack\"\n" + bar + tail},
      {"sheet_stress_point", named("stress-point") + sheet + tail},
      {"sheet_stress_point_damped", named("stress-point") + sheet +
                                        "[stabiliser]\nkind = \"cell\"\nas = \"viscosity\"\n" +
                                        tail},
      {"sheet_stress_point_wide", named("stress-point") + sheet + wide + pair + tail},
      {"sheet_of_linear_law", named("stress-point") + sheet + linear},
      {"sheet_variational", named("variational") + sheet + tail},
      {"sheet_variational_damped", named("variational") + sheet + damped + tail},
      {"sheet_of_two_materials", named("stress-point") + sheet + regions},
      {"strip_mirror", named("mirror") + strip + tail},
      {"strip_thesis", named("thesis") + strip + tail},
  };
}

template <int D>
long allocations_of_ten_sweeps(const Discretisation<D>& body, const Probes<D>& probes,
                               State<D>& state, double dt) {
  SweepOptions options;
  options.threads = worth_threads(body.nodes()) ? omp_get_max_threads() : 1;
  Sweep<D> sweep(body, options);
  BoundaryForces<D> forces(body);
  const PartialEvaluation<D> probed(body, probes.nodes(), probes.points());
  std::vector<double> row(probes.columns().size());
  WorkAndImpulse<D> done;

  const long before = allocations;
  for (int n = 0; n < 10; ++n) {
    sweep.evaluate(state);
    probed.evaluate(body, state);
    probes.sample({body, state, dt}, row);
    sweep.step(state, dt, state.time + dt, forces);
    done.add_step(body, forces, state, {dt, dt, false});
  }
  const long during = allocations - before;

  EXPECT_TRUE(std::isfinite(row.back()));
  return during;
}

template <int D>
long allocations_of_ten_steps(const Scene& scene, const Discretisation<D>& body) {
  const InitialState<D> initial = build_initial<D>(scene, body);
  State<D> state = make_state<D>(body, initial.displacement, initial.velocity);
  evaluate<D>(body, state);
  const double dt = 0.5 * critical_step<D>(body, state).dt;
  start<D>(body, state, dt);
  Vector<D> between = Vector<D>::Constant(0.0537);
  const Probes<D> probes(
      body, {{"p",
              between,
              {"displacement", "velocity", "acceleration", "deformation_gradient", "pk1", "cauchy",
               "pressure", "von_mises"}}});
  std::vector<double> row(probes.columns().size());
  WorkAndImpulse<D> done;
  BoundaryForces<D> forces(body);
  const Instant<D> now{body, state, dt};

  const long before = allocations;
  double kinetic = 0.0;
  for (int n = 0; n < 10; ++n) {
    evaluate<D>(body, state);
    forces.gather(now);
    if (n > 0) done.add_before(forces, now);
    kinetic += balance<D>(now).kinetic;
    probes.sample(now, row);
    done.add_after(forces, now);
    advance<D>(body, state, dt, state.time + dt);
  }
  const long during = allocations - before;

  EXPECT_NE(kinetic, 0.0);
  EXPECT_TRUE(std::isfinite(row.back()));
  return during +
         (Sweep<D>::possible(body) ? allocations_of_ten_sweeps<D>(body, probes, state, dt) : 0);
}

class Step : public testing::TestWithParam<Case> {};

TEST_P(Step, TakesNothingFromTheHeap) {
  const Scene scene = read_scene_text(GetParam().text, GetParam().name);
  long during = -1;

  discretised(scene, [&](const auto& body) { during = allocations_of_ten_steps(scene, body); });

  EXPECT_EQ(during, 0);
}

INSTANTIATE_TEST_SUITE_P(, Step, testing::ValuesIn(cases()), ByName());

/// Large enough to be shared among threads, whose team is kept from step to step.
TEST(SharedStep, TakesNothingFromTheHeap) {
  const Scene scene =
      read_scene_text("[body]\nshape = { box = [[0.0, 0.0], [0.6, 0.6]] }\nspacing = 0.01\n" +
                          tail + "[initial]\nvelocity = { gradient = [[0.1, 0.0], [0.0, 0.2]] }\n",
                      "large");
  const auto body = build<2>(scene);
  ASSERT_GT(body.nodes(), parallel_rows);
  const int before = omp_get_max_threads();
  omp_set_num_threads(2);

  const long during = allocations_of_ten_steps<2>(scene, body);

  omp_set_num_threads(before);
  EXPECT_EQ(during, 0);
}

TEST(AllocationCounter, Counts) {
  const long before = allocations;
  const Eigen::VectorXd some(100);
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace tlsph::property

#endif

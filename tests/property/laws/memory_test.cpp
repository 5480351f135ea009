/// Bodies whose material remembers: the exact stress of a strain path, the energy that is lost, the
/// critical step of what the material has become, and runs that go on bit for bit.

#include "memory_laws.hpp"

#include <fmt/format.h>

#include "../../../src/simulation/run_loop.hpp"
#include "property/bodies.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/points.hpp"
#include "tlsph/stepping/adaptive_step.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph::property {
namespace {

constexpr std::array<double, 3> breaking = {4e6, 1e-3, 1.0};
constexpr std::array<double, 3> creeping = {2e6, 3e6, 4e-3};

/// A bar of one cell, 0.1 m long, the left end fixed and the right one moved: H = u/0.1.
Discretisation<1> one_cell(AnyLaw<1> law, Curve motion) {
  Discretisation<1> bar;
  bar.particles = make_lattice<1>(make_interval(0.0, 0.1), 0.1);
  bar.points = cell_points(bar.particles);
  bar.spacing = bar.particles.spacing;
  bar.gradient = cell_gradient(bar.particles, bar.points);
  bar.divergence = bar.gradient.negative_adjoint(bar.points.V);
  bar.regions = {{std::move(law), density, {}}};
  bar.mass = density * bar.particles.V;
  bar.inverse_mass = VectorField<1>::Zero(2, 1);
  bar.constraints.fixed = {0};
  bar.constraints.curves = {std::move(motion)};
  bar.constraints.moved = {{1, 0}};
  return bar;
}

VectorField<1> at_rest(const Discretisation<1>& bar) {
  return VectorField<1>::Zero(bar.nodes(), 1);
}

/// Loaded beyond yield and back, along straight lines: the stress is exact after any steps, and
/// what the moved end has done is stored, lost or motion, to the square of the step.
TEST(Memory, OfAPlasticBarGivesTheExactStressOfAStrainPath) {
  const double shear = soft_metal[1], yield = soft_metal[2], hardening = soft_metal[3];
  const double there = 5e-3, back = -4e-3;
  const double first = (2 * shear * there - yield) / (3 * shear + hardening);
  const double second =
      (3 * shear * first - 2 * shear * back - yield - hardening * first) / (3 * shear + hardening);
  const Discretisation<1> bar =
      one_cell(given<VonMises<1>>(soft_metal),
               TableCurve{{0.0, 1.0, 3.0}, {0.0, 0.1 * there, 0.1 * back}, {}});
  const double modulus = soft_metal[0] + 4 * shear / 3;
  double missing[2];
  for (const long steps : {300L, 600L}) {
    State<1> state = make_state<1>(bar, at_rest(bar), at_rest(bar));
    march<1>(bar, state, 3.0 / static_cast<double>(steps), steps, steps / 3,
             [&](const State<1>& now, const WorkAndImpulse<1>& done) {
               if (now.step == 0 || 3 * now.step == 2 * steps) return;
               const bool loaded = 3 * now.step == steps;
               EXPECT_NEAR(now.H(0, 0), loaded ? there : back, 1e-15);
               EXPECT_NEAR(now.P(0, 0),
                           modulus * now.H(0, 0) - 2 * shear * (loaded ? first : first - second),
                           1e-9);
               const double lost = yield * (loaded ? first : first + second) * 0.1;
               EXPECT_NEAR(dissipated_energy(bar, now), lost, 1e-12);
               if (loaded) return;
               const Balance<1> balanced = balance<1>({bar, now, now.last_dt});
               EXPECT_EQ(balanced.dissipated, dissipated_energy(bar, now));
               missing[steps / 600] = std::abs(balanced.elastic + balanced.dissipated +
                                               balanced.kinetic - done.external_work) /
                                      done.external_work;
             });
  }
  EXPECT_LT(missing[1], 1e-4);
  EXPECT_LT(missing[1], 0.6 * missing[0]);
}

/// The law sees the time that has passed, also where steps differ.
TEST(Memory, OfAViscousBarRelaxesAlongTheExactCurve) {
  const double strain = 1e-3, rise = 4e-3, end = 1e-2;
  const Discretisation<1> bar =
      one_cell(given<ViscousBar>(creeping), TableCurve{{0.0, rise}, {0.0, 0.1 * strain}, {}});
  State<1> state = make_state<1>(bar, at_rest(bar), at_rest(bar));
  evaluate<1>(bar, state);
  start<1>(bar, state, 1e-4);
  for (const double dt : {1e-4, 2e-4})
    while (state.time < (dt < 1.5e-4 ? rise : end) - 1e-9) {
      advance<1>(bar, state, dt, state.time + dt);
      evaluate<1>(bar, state);
    }

  const double tau = creeping[2];
  const double expected = creeping[0] * strain + creeping[1] * strain / rise * tau *
                                                     (1 - std::exp(-rise / tau)) *
                                                     std::exp(-(end - rise) / tau);
  EXPECT_NEAR(state.P(0, 0), expected, 1e-9 * expected);
}

/// (1 − d) E: the critical step grows by 1/√(1 − d), and stays when the body is unloaded.
TEST(Memory, SetsTheCriticalStep) {
  Discretisation<1> bar = build<1>(scene_of({"interval", "stress-point", "", "", ""}));
  bar.regions.front().law = given<DamagedBar>(breaking);
  State<1> state = make_state<1>(bar, at_rest(bar), at_rest(bar));
  evaluate<1>(bar, state);
  const double virgin = critical_step<1>(bar, state).dt;
  AdaptiveStep<1> follower(bar, state, 0.9);
  start<1>(bar, state, 1e-6);

  state.u = 4e-3 * bar.particles.X;  // d = 3/4
  evaluate<1>(bar, state);
  EXPECT_NEAR(critical_step<1>(bar, state).dt, 2 * virgin, 1e-9 * virgin);
  EXPECT_LE(follower.bound(state), virgin);
  AdaptiveStep<1> of_the_damaged(bar, state, 0.9);
  EXPECT_NEAR(of_the_damaged.critical().dt, 2 * virgin, 1e-9 * virgin);
  state.v.setZero();
  state.f.setZero();
  advance<1>(bar, state, 1e-6, 1e-6);
  state.u.setZero();
  evaluate<1>(bar, state);
  EXPECT_NEAR(critical_step<1>(bar, state).dt, 2 * virgin, 1e-9 * virgin);

  // a bound knows that another body of the same strains is stiffer
  State<1> healthy = make_state<1>(bar, at_rest(bar), at_rest(bar));
  evaluate<1>(bar, healthy);
  EXPECT_LE(of_the_damaged.bound(healthy), virgin);
}

/// The book of a struck body that flows balances to the order of the step, and what it has lost
/// does not come back.
TEST(Memory, OfAFreeBodyLosesEnergyAndNoMomentum) {
  for (const char* layout : {"box", "jittered"}) {
    Discretisation<2> body = build<2>(scene_of({layout, "variational", "", "wendland-c2", "2.5"}));
    body.regions.front().law = given<VonMises<2>>(soft_metal);
    VectorField<2> v = VectorField<2>::Zero(body.nodes(), 2);
    for (Index q = 0; q < body.nodes(); ++q) v(q, 0) = body.particles.X(q, 0) > 0.04 ? -1.0 : 1.0;
    const Vector<2> momentum = v.transpose() * body.mass;
    double missing[2];
    for (const int half : {0, 1}) {
      State<2> state = make_state<2>(body, VectorField<2>::Zero(body.nodes(), 2), v);
      evaluate<2>(body, state);
      const double dt = 0.4 * critical_step<2>(body, state).dt / (1 + half);
      const long steps = 200 * (1 + half);
      double first = 0.0, lost = 0.0;
      march<2>(body, state, dt, steps, 20, [&](const State<2>& now, const WorkAndImpulse<2>&) {
        const Balance<2> balanced = balance<2>({body, now, dt});
        if (now.step == 0) first = balanced.kinetic + balanced.elastic;
        EXPECT_GE(balanced.dissipated, lost);
        lost = balanced.dissipated;
        EXPECT_LE((balanced.linear_momentum - momentum).norm(), 1e-12 * balanced.momentum_scale);
        missing[half] = std::abs(balanced.kinetic + balanced.elastic + lost - first) / first;
      });
      EXPECT_GT(lost, 0.1 * first);
    }
    EXPECT_LT(missing[1], 5e-3) << layout;
    EXPECT_LT(missing[1], 0.7 * missing[0]) << layout;
  }
}

/// Sweeps are for laws without memory; a second look changes nothing.
TEST(Memory, IsMadeByTheStepAndNotByLooks) {
  Discretisation<2> body = build<2>(scene_of({"box", "stress-point", "", "", ""}));
  EXPECT_TRUE(Sweep<2>::possible(body));
  EXPECT_EQ(make_state<2>(body, body.particles.X, body.particles.X).past.size(), 0);
  body.regions.front().law = given<VonMises<2>>(soft_metal);
  EXPECT_FALSE(Sweep<2>::possible(body));
  EXPECT_FALSE(body.linear());
  Random random(4);
  State<2> state =
      make_state<2>(body, deformed<2>(body, random), random.field<2>(body.nodes(), 1.0));
  evaluate<2>(body, state);
  start<2>(body, state, 1e-5);
  advance<2>(body, state, 1e-5, 1e-5);
  evaluate<2>(body, state);
  const TensorField<2> P = state.P;
  const MemoryField memory = state.memory;

  evaluate<2>(body, state);

  EXPECT_EQ(state.P, P);
  EXPECT_EQ(state.memory, memory);
  EXPECT_GT(state.past.norm(), 0.0);
}

/// A law with a memory in one region only: points of the other keep what they are.
TEST(Memory, OfOneRegionLeavesTheOtherAlone) {
  Discretisation<2> body = build<2>(scene_of({"box", "stress-point", "", "", ""}));
  body.regions.push_back(body.regions.front());
  body.regions.back().law = given<VonMises<2>>(soft_metal);
  for (int s = 0; s < body.points.size(); ++s) body.regions[s % 2 == 0 ? 0 : 1].points.push_back(s);
  Random random(4);
  const State<2> state = evaluated<2>(body, deformed<2>(body, random));
  for (Index s = 0; s < state.memory.rows(); ++s) {
    EXPECT_EQ(state.memory.row(s).norm() > 0.0, s % 2 == 1);
    if (s % 2 == 0) {
      EXPECT_EQ(tensor_at<2>(state.P, s),
                pk1<2>(body.regions.front().law, tensor_at<2>(state.H, s)));
    }
  }
}

/// A run that goes on from a checkpoint on its way ends in the same bits, with steps that adapt
/// or are given.
TEST(Memory, IsKeptByCheckpoints) {
  namespace fs = std::filesystem;
  for (const char* step : {"", "step = 2e-5\n"}) {
    const Scene scene = read_scene_text(fmt::format(R"(
formulation = "variational"
[body]
shape = {{ box = [[0.0, 0.0], [0.2, 0.1]] }}
spacing = 0.005
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = {{ x = {{ curve = "sine-squared", amplitude = 0.004, duration = 8e-3 }} }}
[material]
law = "neo-hookean"
young = 2e6
poisson = 0.3
density = 1000
[time]
end = 6e-3
{}[output]
frames = 4
energy_every = 4
checkpoint_steps = 7
)",
                                                    step),
                                        "memory");
    Discretisation<2> body = build<2>(scene);
    body.regions.front().law = given<VonMises<2>>(soft_metal);
    const fs::path out = fs::temp_directory_path() / fmt::format("tlsph_memory_{}", ::getpid());
    fs::remove_all(out);
    fs::create_directories(out);
    RunOptions options;
    options.out = out;
    Summary whole, resumed;

    RunLoop<2>(scene, options, body, whole).run();
    options.resume = true;
    RunLoop<2>(scene, options, body, resumed).run();
    fs::remove_all(out);

    ASSERT_GT(whole.steps, 8);
    ASSERT_NE(whole.steps % 7, 0);
    EXPECT_GT(whole.energy.dissipated, 0.1 * whole.energy.external_work);
    EXPECT_LT(whole.energy.drift_relative, 1e-2);
    EXPECT_EQ(resumed.steps, whole.steps);
    EXPECT_EQ(resumed.energy.kinetic, whole.energy.kinetic);
    EXPECT_EQ(resumed.energy.elastic, whole.energy.elastic);
    EXPECT_EQ(resumed.energy.dissipated, whole.energy.dissipated);
    EXPECT_EQ(resumed.energy.external_work, whole.energy.external_work);
    EXPECT_EQ(resumed.energy.drift_relative, whole.energy.drift_relative);
  }
}

}  // namespace
}  // namespace tlsph::property

#pragma once
/// \file
/// Sweeps of all kinds, and the step they must make: that of `evaluate` and `advance`.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "property/bodies.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph::property {

/// How a sweep is made; more threads than processors are threads all the same.
inline std::vector<SweepOptions> ways(StepForm form = StepForm::points) {
  std::vector<SweepOptions> all;
  for (const int threads : {1, 2, 3})
    all.push_back({threads, false, Instructions::widest, false, form});
  for (const Instructions set : {Instructions::baseline, Instructions::avx2, Instructions::avx512})
    if (available(set)) all.push_back({1, false, set, false, form});
  return all;
}

inline constexpr double now = 0.3;
inline constexpr double dt = 1e-5;
inline constexpr double way_here = 0.9 * dt;  // the step before was another

/// A deformed body on its way, its middle at rest: what cancels in differences of a displacement is
/// not what is compared here.
template <int D>
State<D> moving(const Discretisation<D>& body, double strain = 0.1) {
  Random random(11);
  const Tensor<D> A = random.tensor<D>(strain);
  const Vector<D> middle = body.particles.X.colwise().mean().transpose();
  VectorField<D> u = affine<D>(body.particles.X, A, -A * middle) +
                     random.field<D>(body.nodes(), 0.5 * strain * body.spacing);
  State<D> state = make_state<D>(body, std::move(u), random.field<D>(body.nodes(), 3.0));
  state.time = now;
  state.last_dt = way_here;
  return state;
}

template <int D>
void expect_the_same_fields(Sweep<D>& sweep, State<D> state, const State<D>& expected) {
  sweep.evaluate(state);
  const auto largest = [](const auto& field) { return field.cwiseAbs().maxCoeff(); };
  EXPECT_LE(largest(state.H - expected.H), 1e-13 * largest(expected.H));
  EXPECT_LE(largest(state.P - expected.P), 1e-13 * largest(expected.P));
  EXPECT_LE(largest(state.f - expected.f), 1e-13 * largest(expected.f));
  if (expected.viscous.size() > 0) {
    EXPECT_LE(largest(state.viscous - expected.viscous), 1e-13 * largest(expected.viscous));
  }
}

/// Books and fields after one step, each way, against those of `evaluate` and `advance`.
template <int D>
void expect_the_same_step(const Discretisation<D>& body, double strain = 0.1,
                          StepForm form = StepForm::points) {
  ASSERT_TRUE(Sweep<D>::possible(body));
  State<D> expected = moving<D>(body, strain);
  WorkAndImpulse<D> books;
  evaluate<D>(body, expected);
  State<D> at_now = moving<D>(body, strain);
  evaluate<D>(body, at_now);
  const double force = expected.f.cwiseAbs().maxCoeff();
  const double velocity = 3.0 + dt * body.inverse_mass.maxCoeff() * force;
  BoundaryForces<D> gathered(body);
  gathered.gather({body, expected, dt});
  books.add_before(gathered, {body, expected, dt});
  books.add_after(gathered, {body, expected, dt});
  advance<D>(body, expected, dt, now + dt);

  for (const SweepOptions& way : ways(form)) {
    SCOPED_TRACE(fmt::format("{} threads, instructions {}, form {}", way.threads,
                             static_cast<int>(way.instructions), static_cast<int>(form)));
    State<D> state = moving<D>(body, strain);
    Sweep<D> sweep(body, way);
    ASSERT_EQ(sweep.stiffness_multiply_adds().has_value(), form == StepForm::stiffness);
    BoundaryForces<D> forces(body);
    WorkAndImpulse<D> own;
    sweep.step(state, dt, now + dt, forces);
    own.add_step(body, forces, state, {way_here, dt, false});

    expect_the_same_fields(sweep, moving<D>(body, strain), at_now);
    EXPECT_LE((state.v - expected.v).cwiseAbs().maxCoeff(), 1e-13 * velocity);
    EXPECT_LE((state.u - expected.u).cwiseAbs().maxCoeff(),
              1e-13 * expected.u.cwiseAbs().maxCoeff());
    EXPECT_EQ(forces.largest_speed, state.v.cwiseAbs().maxCoeff());
    EXPECT_EQ(state.step, expected.step);
    EXPECT_EQ(state.time, expected.time);
    EXPECT_EQ(state.last_dt, expected.last_dt);
    const double impulse = dt * force * static_cast<double>(body.nodes());
    EXPECT_NEAR(own.external_work, books.external_work, 1e-13 * impulse * velocity);
    EXPECT_NEAR(own.dissipated, books.dissipated, 1e-13 * impulse * velocity);
    EXPECT_LE((own.impulse - books.impulse).norm(), 1e-13 * impulse);
    EXPECT_NEAR(own.angular_impulse, books.angular_impulse, 1e-13 * impulse);
  }
}

/// Fine enough for several blocks of nodes and of points.
inline std::string fine_spacing(const Variant& variant) {
  return variant.one_dimensional() ? "body.spacing=4e-4" : "body.spacing=4e-3";
}

/// One kernel stands for all: rows differ by their pattern, not by where their weights come from.
inline std::vector<Variant> variants_of_one_kernel() {
  std::vector<Variant> all;
  for (const Variant& variant : adjoint_variants())
    if (variant.layout != "cloud" && (variant.on_cells() || variant.kernel == "wendland-c2"))
      all.push_back(variant);  // a cloud has the spacing it has
  return all;
}

/// Everything a boundary can do at once.
inline const std::string busy_scene = R"(
gravity = [1.0, -9.81]
[body]
shape = { box = [[0.0, 0.0], [0.2, 0.1]] }
spacing = 4e-3
[material]
law = "neo-hookean"
young = 2e6
poisson = 0.3
density = 1000
[[material.region]]
box = [[0.0, 0.0], [0.1, 0.1]]
law = "st-venant-kirchhoff"
density = 2000
[[boundary]]
where = "left"
fixed = "x"
[[boundary]]
where = "bottom"
displacement = { y = { curve = "ramp", amplitude = 1e-3, rise = 1.0 } }
[[boundary]]
where = "right"
traction = { curve = "constant", amplitude = 3e3 }
[[boundary]]
where = "top"
traction = [1e3, -2e3]
[time]
end = 1.0
)";

}  // namespace tlsph::property

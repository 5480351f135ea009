/// A sweep makes the step that `evaluate` and `advance` make, operator by operator, whatever the
/// storage of its rows, its threads and its instructions.

#include "tlsph/dynamics/sweep.hpp"
#include "tlsph/dynamics/excerpt.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "property/bodies.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph::property {
namespace {

/// How a sweep is made; more threads than processors are threads all the same.
std::vector<SweepOptions> ways(StepForm form = StepForm::points) {
  std::vector<SweepOptions> all;
  for (const int threads : {1, 2, 3})
    all.push_back({threads, false, Instructions::widest, false, form});
  for (const Instructions set : {Instructions::baseline, Instructions::avx2, Instructions::avx512})
    if (available(set)) all.push_back({1, false, set, false, form});
  return all;
}

constexpr double now = 0.3;
constexpr double dt = 1e-5;
constexpr double way_here = 0.9 * dt;  // the step before was another

/// A deformed body on its way, its middle at rest: what cancels in differences of a displacement is
/// not what is compared here.
template <int D>
State<D> moving(const Discretisation<D>& disc, double strain = 0.1) {
  Random random(11);
  const Tensor<D> A = random.tensor<D>(strain);
  const Vector<D> middle = disc.particles.X.colwise().mean().transpose();
  VectorField<D> u = affine<D>(disc.particles.X, A, -A * middle) +
                     random.field<D>(disc.nodes(), 0.5 * strain * disc.spacing);
  State<D> state = make_state<D>(disc, std::move(u), random.field<D>(disc.nodes(), 3.0));
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
void expect_the_same_step(const Discretisation<D>& disc, double strain = 0.1,
                          StepForm form = StepForm::points) {
  ASSERT_TRUE(Sweep<D>::possible(disc));
  State<D> expected = moving<D>(disc, strain);
  Ledger<D> books;
  evaluate<D>(disc, expected);
  State<D> at_now = moving<D>(disc, strain);
  evaluate<D>(disc, at_now);
  const double force = expected.f.cwiseAbs().maxCoeff();
  const double velocity = 3.0 + dt * disc.inverse_mass.maxCoeff() * force;
  books.arrive(disc, expected, dt);
  books.depart(disc, expected, dt);
  advance<D>(disc, expected, dt, now + dt);

  for (const SweepOptions& way : ways(form)) {
    SCOPED_TRACE(fmt::format("{} threads, instructions {}, form {}", way.threads,
                             static_cast<int>(way.instructions), static_cast<int>(form)));
    State<D> state = moving<D>(disc, strain);
    Sweep<D> sweep(disc, way);
    ASSERT_EQ(sweep.stiffness_multiply_adds().has_value(), form == StepForm::stiffness);
    BoundaryForces<D> forces = sweep.boundary_forces();
    Ledger<D> own;
    sweep.step(state, dt, now + dt, forces);
    own.book(disc, forces, state, now, way_here, dt, false);

    expect_the_same_fields(sweep, moving<D>(disc, strain), at_now);
    EXPECT_LE((state.v - expected.v).cwiseAbs().maxCoeff(), 1e-13 * velocity);
    EXPECT_LE((state.u - expected.u).cwiseAbs().maxCoeff(),
              1e-13 * expected.u.cwiseAbs().maxCoeff());
    EXPECT_EQ(forces.largest_speed, state.v.cwiseAbs().maxCoeff());
    EXPECT_EQ(state.step, expected.step);
    EXPECT_EQ(state.time, expected.time);
    EXPECT_EQ(state.last_dt, expected.last_dt);
    const double impulse = dt * force * static_cast<double>(disc.nodes());
    EXPECT_NEAR(own.external_work, books.external_work, 1e-13 * impulse * velocity);
    EXPECT_NEAR(own.dissipated, books.dissipated, 1e-13 * impulse * velocity);
    EXPECT_LE((own.impulse - books.impulse).norm(), 1e-13 * impulse);
    EXPECT_NEAR(own.angular_impulse, books.angular_impulse, 1e-13 * impulse);
  }
}

/// Fine enough for several blocks of nodes and of points.
std::string fine_spacing(const Variant& variant) {
  return variant.one_dimensional() ? "body.spacing=4e-4" : "body.spacing=4e-3";
}

class SweepOfOperators : public testing::TestWithParam<Variant> {};

TEST_P(SweepOfOperators, IsTheStepOfTheirProducts) {
  std::vector<std::vector<std::string>> stabilisers = {{"stabiliser.kind=none"}};
  for (const char* action : {"stiffness", "viscosity"})
    stabilisers.push_back(
        {"stabiliser.kind=" + GetParam().stabiliser(), std::string("stabiliser.as=") + action});
  for (std::vector<std::string> overrides : stabilisers) {
    SCOPED_TRACE(overrides.back());
    overrides.push_back(fine_spacing(GetParam()));
    discretised(scene_of(GetParam(), overrides), [](auto disc) {
      set_material(disc, {"neo-hookean", "strain"});
      expect_the_same_step(disc);
    });
  }
}

/// One kernel stands for all: rows differ by their pattern, not by where their weights come from.
std::vector<Variant> variants_of_one_kernel() {
  std::vector<Variant> all;
  for (const Variant& variant : adjoint_variants())
    if (variant.layout != "cloud" && (variant.on_cells() || variant.kernel == "wendland-c2"))
      all.push_back(variant);  // a cloud has the spacing it has
  return all;
}

INSTANTIATE_TEST_SUITE_P(, SweepOfOperators, testing::ValuesIn(variants_of_one_kernel()), ByName());

class SweepOfLaws : public testing::TestWithParam<const char*> {};

TEST_P(SweepOfLaws, IsTheStepOfTheirStress) {
  for (const Material& material : materials()) {
    SCOPED_TRACE(std::string(material.law) + " " + material.assumption);
    discretised(scene_of({GetParam(), "stress-point", "", "", ""}), [&](auto disc) {
      set_material(disc, material);
      expect_the_same_step(disc);
      expect_the_same_step(disc, 0.25);
      expect_the_same_step(disc, 0.01);  // logarithms of small changes of volume alone
    });
  }
}

INSTANTIATE_TEST_SUITE_P(, SweepOfLaws, testing::Values("interval", "box", "jittered"), ByName());

/// Everything a boundary can do at once.
const std::string busy_scene = R"(
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

class SweepOfBoundaries : public testing::TestWithParam<const char*> {};

TEST_P(SweepOfBoundaries, IsTheStepOfTheirConditions) {
  expect_the_same_step(build<2>(read_scene_text(busy_scene, "busy", {GetParam()})), 0.01);
}

INSTANTIATE_TEST_SUITE_P(, SweepOfBoundaries,
                         testing::Values("body.jitter=0", "body.jitter=0.2",
                                         "formulation=variational"),
                         [](const auto& test) {
                           return test.index == 0   ? "lattice"
                                  : test.index == 1 ? "jittered"
                                                    : "collocated";
                         });

/// Bodies of linear laws, which the stiffness may step.
class SweepOfStencils : public testing::TestWithParam<Variant> {};

TEST_P(SweepOfStencils, IsTheStepOfTheProducts) {
  for (const Material& material : materials()) {
    if (!material.linear()) continue;
    for (const std::string& stabiliser : {std::string("none"), GetParam().stabiliser()}) {
      SCOPED_TRACE(material.assumption + (", " + stabiliser));
      std::vector<std::string> overrides = as_stiffness(stabiliser);
      overrides.push_back(fine_spacing(GetParam()));
      discretised(scene_of(GetParam(), overrides), [&](auto disc) {
        set_material(disc, material);
        expect_the_same_step(disc);
        expect_the_same_step(disc, 0.1, StepForm::stiffness);
      });
    }
  }
}

/// On a lattice rows are shared; wide gradients make many kinds of them at edges.
std::vector<Variant> variants_of_lattices() {
  std::vector<Variant> all;
  for (const Variant& variant : variants_of_one_kernel())
    if ((variant.layout == "interval" || variant.layout == "box") && variant.consistency.empty())
      all.push_back(variant);
  return all;
}

INSTANTIATE_TEST_SUITE_P(, SweepOfStencils, testing::ValuesIn(variants_of_lattices()), ByName());

TEST(SweepOfStiffness, IsTheStepOfTheProductsOfSmallBodies) {
  for (const char* size : {"0.02", "0.01", "0.005"})
    for (const char* layout : {"interval", "box"}) {
      SCOPED_TRACE(fmt::format("{} of {} m", layout, size));
      const Variant variant{layout, "stress-point", "", "", ""};
      std::vector<std::string> overrides = as_stiffness(variant.stabiliser());
      overrides.push_back(std::string("body.spacing=") + size);
      discretised(scene_of(variant, overrides),
                  [](const auto& disc) { expect_the_same_step(disc, 0.1, StepForm::stiffness); });
    }
}

/// Two linear materials, side by side, with all that boundaries do.
TEST(SweepOfStiffness, IsTheStepOfBoundariesAndRegions) {
  for (const char* split : {"0.1", "0.034", "0.197"}) {
    std::string text = busy_scene;
    for (const char* law : {"neo-hookean", "st-venant-kirchhoff"})
      text.replace(text.find(law), std::string_view(law).size(), "linear-elastic");
    text.replace(text.find("[0.1, 0.1]"), 10,
                 fmt::format("[{}, 0.1]]\nyoung = 5e6\npoisson = 0.2\n#", split));
    Discretisation<2> disc = build<2>(read_scene_text(text, "busy"));
    ASSERT_EQ(disc.regions.size(), 2);

    expect_the_same_step(disc, 0.01, StepForm::stiffness);
  }
}

/// What one node gains others lose, far from where the body was.
TEST(SweepOfStiffness, KeepsMomentaOfAFreeBody) {
  const Discretisation<2> disc = build<2>(
      scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3", "stabiliser.kind=cell"}));
  State<2> state = moving<2>(disc);
  state.u.rowwise() += Eigen::RowVector2d(0.5, -0.25);
  const auto momenta = [&] {
    const VectorField<2> p = state.v.array().colwise() * disc.mass.array();
    const auto& X = disc.particles.X;
    return Eigen::Vector3d(p.col(0).sum(), p.col(1).sum(),
                           X.col(0).dot(p.col(1)) - X.col(1).dot(p.col(0)));
  };
  const Eigen::Vector3d before = momenta();
  const double size = disc.mass.sum() * state.v.cwiseAbs().maxCoeff();
  Sweep<2> sweep(disc, {1, false, Instructions::widest, false, StepForm::stiffness});
  BoundaryForces<2> forces = sweep.boundary_forces();

  for (int n = 1; n <= 100; ++n) sweep.step(state, dt, now + n * dt, forces);

  EXPECT_LE((momenta() - before).cwiseAbs().maxCoeff(), 1e-14 * size);
}

TEST(SweepOfStiffness, MovesNothingThatIsCarried) {
  const Discretisation<2> disc = build<2>(
      scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3", "stabiliser.kind=cell"}));
  State<2> state = make_state<2>(disc, VectorField<2>::Constant(disc.nodes(), 2, 7.1),
                                 VectorField<2>::Zero(disc.nodes(), 2));
  state.last_dt = dt;
  Sweep<2> sweep(disc, {1, false, Instructions::widest, false, StepForm::stiffness});
  BoundaryForces<2> forces = sweep.boundary_forces();

  sweep.step(state, dt, dt, forces);

  EXPECT_EQ(state.v.cwiseAbs().maxCoeff(), 0.0);
}

TEST(SweepOfStiffness, IsTakenWhereItIsLessWork) {
  const auto takes = [](const Variant& variant, const char* override_of) {
    return Sweep<2>(build<2>(scene_of(variant, {"body.spacing=4e-3", override_of})))
        .stiffness_multiply_adds()
        .has_value();
  };
  const Variant cells{"box", "stress-point", "", "", ""};

  EXPECT_TRUE(takes(cells, "stabiliser.kind=cell"));
  EXPECT_TRUE(takes(cells, "stabiliser.kind=none"));
  EXPECT_FALSE(takes(cells, "material.law=neo-hookean"));
  EXPECT_FALSE(takes(cells, "body.jitter=0.2"));
  EXPECT_FALSE(takes({"box", "variational", "", "wendland-c2", "2.5"}, "stabiliser.kind=none"));
}

/// What probes look at, bit by bit what a look at everything shows there.
TEST(Excerpt, IsTheRowsOfTheWhole) {
  const Discretisation<2> disc = build<2>(read_scene_text(busy_scene, "busy", {}));
  State<2> whole = moving<2>(disc, 0.01);
  State<2> part = moving<2>(disc, 0.01);
  const std::vector<Index> nodes = {700, 0, 3, disc.nodes() - 1};
  const std::vector<Index> points = {17, 5};

  evaluate<2>(disc, whole);
  Excerpt<2>(disc, nodes, points).evaluate(disc, part);

  for (const Index q : nodes) EXPECT_EQ(part.f.row(q), whole.f.row(q)) << q;
  for (const Index s : points) {
    EXPECT_EQ(part.H.row(s), whole.H.row(s)) << s;
    EXPECT_EQ(part.P.row(s), whole.P.row(s)) << s;
  }
  EXPECT_EQ(part.f.row(100), (VectorField<2>::Zero(1, 2)));
}

TEST(Sweep, KeepsRunsOfAsManyThreadsBitIdentical) {
  const Discretisation<2> disc = build<2>(
      scene_of({"jittered", "variational", "", "wendland-c2", "2.5"}, {"body.spacing=4e-3"}));
  const auto run = [&] {
    State<2> state = moving<2>(disc);
    Sweep<2> sweep(disc, {2, false, Instructions::widest});
    BoundaryForces<2> forces = sweep.boundary_forces();
    for (int n = 1; n <= 50; ++n) sweep.step(state, dt, now + n * dt, forces);
    return state.u;
  };

  const VectorField<2> first = run();

  for (int again = 0; again < 3; ++again) EXPECT_EQ(run(), first);
}

/// A body in which one particle is thrown over its neighbours.
TEST(Sweep, RestoresTheStateThatHasNoStress) {
  Discretisation<2> disc =
      build<2>(scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3"}));
  set_material(disc, {"neo-hookean", "strain"});
  const auto broken = [&] {
    State<2> state = moving<2>(disc);
    state.u(disc.nodes() / 2, 0) += 5.0 * disc.spacing;
    return state;
  };
  for (const SweepOptions& way : ways()) {
    State<2> state = broken();
    Sweep<2> sweep(disc, way);
    BoundaryForces<2> forces = sweep.boundary_forces();

    EXPECT_THROW(sweep.step(state, dt, now + dt, forces), NumericalError);

    EXPECT_LE((state.u - broken().u).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE((state.v - broken().v).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(state.step, 0);
    EXPECT_EQ(state.time, now);
  }
}

/// A linear body in which one particle is nowhere.
TEST(SweepOfStiffness, RestoresTheStateThatHasNoStress) {
  const Discretisation<2> disc =
      build<2>(scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3"}));
  constexpr double far = 1e303;
  const auto broken = [&] {
    State<2> state = moving<2>(disc);
    state.u(disc.nodes() / 2, 0) = far;
    return state;
  };
  for (const StepForm form : {StepForm::points, StepForm::stiffness})
    for (const SweepOptions& way : ways(form)) {
      State<2> state = broken();
      Sweep<2> sweep(disc, way);
      BoundaryForces<2> forces = sweep.boundary_forces();

      EXPECT_THROW(sweep.step(state, dt, now + dt, forces), NumericalError);

      EXPECT_EQ(state.u(disc.nodes() / 2, 0), far);
      state.u(disc.nodes() / 2, 0) = broken().u(disc.nodes() / 2, 0);
      EXPECT_LE((state.u - broken().u).cwiseAbs().maxCoeff(), 1e-15);
      EXPECT_LE((state.v - broken().v).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_EQ(state.step, 0);
      EXPECT_EQ(state.time, now);
    }
}

/// Weights of 24 bits: forces as good as that, and none from a rigid displacement.
TEST(Sweep, WithSingleWeightsDiffersByTheirRounding) {
  const Discretisation<2> disc = build<2>(
      scene_of({"jittered", "variational", "", "wendland-c2", "2.5"}, {"body.spacing=4e-3"}));
  State<2> expected = moving<2>(disc);
  evaluate<2>(disc, expected);
  const double change = dt * disc.inverse_mass.maxCoeff() * expected.f.cwiseAbs().maxCoeff();
  advance<2>(disc, expected, dt, now + dt);
  Sweep<2> sweep(disc, {1, true, Instructions::widest});
  BoundaryForces<2> forces = sweep.boundary_forces();
  State<2> state = moving<2>(disc);
  State<2> carried = make_state<2>(disc, VectorField<2>::Constant(disc.nodes(), 2, 7.0),
                                   VectorField<2>::Zero(disc.nodes(), 2));
  carried.last_dt = dt;

  sweep.step(state, dt, now + dt, forces);
  sweep.step(carried, dt, dt, forces);

  const double difference = (state.v - expected.v).cwiseAbs().maxCoeff();
  EXPECT_GT(difference, 1e-10 * change);
  EXPECT_LE(difference, 1e-6 * change);
  EXPECT_EQ(carried.v.cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace tlsph::property

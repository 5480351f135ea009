/// A sweep makes the step that `evaluate` and `advance` make, operator by operator, whatever the
/// storage of its rows, its threads and its instructions.

#include "property/sweeps.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/team.hpp"
#include "tlsph/dynamics/partial_evaluation.hpp"

namespace tlsph::property {
namespace {

class SweepOfOperators : public testing::TestWithParam<Variant> {};

TEST_P(SweepOfOperators, IsTheStepOfTheirProducts) {
  std::vector<std::vector<std::string>> stabilisers = {{"stabiliser.kind=none"}};
  for (const char* action : {"stiffness", "viscosity"})
    stabilisers.push_back(
        {"stabiliser.kind=" + GetParam().stabiliser(), std::string("stabiliser.as=") + action});
  for (std::vector<std::string> overrides : stabilisers) {
    SCOPED_TRACE(overrides.back());
    overrides.push_back(fine_spacing(GetParam()));
    discretised(scene_of(GetParam(), overrides), [](auto body) {
      set_material(body, {"neo-hookean", "strain"});
      expect_the_same_step(body);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(, SweepOfOperators, testing::ValuesIn(variants_of_one_kernel()), ByName());

class SweepOfLaws : public testing::TestWithParam<const char*> {};

TEST_P(SweepOfLaws, IsTheStepOfTheirStress) {
  for (const Material& material : materials()) {
    SCOPED_TRACE(std::string(material.law) + " " + material.assumption);
    discretised(scene_of({GetParam(), "stress-point", "", "", ""}), [&](auto body) {
      set_material(body, material);
      expect_the_same_step(body);
      expect_the_same_step(body, 0.25);
      expect_the_same_step(body, 0.01);  // logarithms of small changes of volume alone
    });
  }
}

INSTANTIATE_TEST_SUITE_P(, SweepOfLaws, testing::Values("interval", "box", "jittered"), ByName());

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

/// What probes look at, bit by bit what a look at everything shows there.
TEST(PartialEvaluation, IsTheRowsOfTheWhole) {
  const Discretisation<2> body = build<2>(read_scene_text(busy_scene, "busy", {}));
  State<2> whole = moving<2>(body, 0.01);
  State<2> part = moving<2>(body, 0.01);
  const std::vector<Index> nodes = {700, 0, 3, body.nodes() - 1};
  const std::vector<Index> points = {17, 5};

  evaluate<2>(body, whole);
  PartialEvaluation<2>(body, nodes, points).evaluate(body, part);

  for (const Index q : nodes) EXPECT_EQ(part.f.row(q), whole.f.row(q)) << q;
  for (const Index s : points) {
    EXPECT_EQ(part.H.row(s), whole.H.row(s)) << s;
    EXPECT_EQ(part.P.row(s), whole.P.row(s)) << s;
  }
  EXPECT_EQ(part.f.row(100), (VectorField<2>::Zero(1, 2)));
}

TEST(Sweep, KeepsRunsOfAsManyThreadsBitIdentical) {
  const Discretisation<2> body = build<2>(
      scene_of({"jittered", "variational", "", "wendland-c2", "2.5"}, {"body.spacing=4e-3"}));
  const auto run = [&] {
    State<2> state = moving<2>(body);
    Sweep<2> sweep(body, {2, false, Instructions::widest});
    BoundaryForces<2> forces(body);
    for (int n = 1; n <= 50; ++n) sweep.step(state, dt, now + n * dt, forces);
    return state.u;
  };

  const VectorField<2> first = run();

  for (int again = 0; again < 3; ++again) EXPECT_EQ(run(), first);

  // Where somebody else has the team, one thread makes the parts of both.
  const Team::Turn turn;
  ASSERT_TRUE(turn.held);
  EXPECT_EQ(run(), first);
}

/// A body in which one particle is thrown over its neighbours.
TEST(Sweep, RestoresTheStateThatHasNoStress) {
  Discretisation<2> body =
      build<2>(scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3"}));
  set_material(body, {"neo-hookean", "strain"});
  const auto broken = [&] {
    State<2> state = moving<2>(body);
    state.u(body.nodes() / 2, 0) += 5.0 * body.spacing;
    return state;
  };
  for (const SweepOptions& way : ways()) {
    State<2> state = broken();
    Sweep<2> sweep(body, way);
    BoundaryForces<2> forces(body);

    EXPECT_THROW(sweep.step(state, dt, now + dt, forces), NumericalError);

    EXPECT_LE((state.u - broken().u).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE((state.v - broken().v).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_EQ(state.step, 0);
    EXPECT_EQ(state.time, now);
  }
}

/// Weights of 24 bits: forces as good as that, and none from a rigid displacement.
TEST(Sweep, WithSingleWeightsDiffersByTheirRounding) {
  const Discretisation<2> body = build<2>(
      scene_of({"jittered", "variational", "", "wendland-c2", "2.5"}, {"body.spacing=4e-3"}));
  State<2> expected = moving<2>(body);
  evaluate<2>(body, expected);
  const double change = dt * body.inverse_mass.maxCoeff() * expected.f.cwiseAbs().maxCoeff();
  advance<2>(body, expected, dt, now + dt);
  Sweep<2> sweep(body, {1, true, Instructions::widest});
  BoundaryForces<2> forces(body);
  State<2> state = moving<2>(body);
  State<2> carried = make_state<2>(body, VectorField<2>::Constant(body.nodes(), 2, 7.0),
                                   VectorField<2>::Zero(body.nodes(), 2));
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

/// What a scene becomes: materials where it says, masses, strengths of stabilisers.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

const std::string sheet = R"(
[body]
shape = { box = [[0.0, 0.0], [0.4, 0.2]] }
spacing = 0.02
[material]
law = "linear-elastic"
young = 2e6
poisson = 0.25
density = 1000
[time]
end = 1e-3
)";

Scene scene_with(const std::vector<std::string>& overrides) {
  return read_scene_text(sheet, "sheet.toml", overrides);
}

const std::string two_regions =
    "material.region=[{box=[[0.1, 0.0], [0.3, 0.2]], density=3000.0}, "
    "{box=[[0.2, 0.0], [0.4, 0.1]], density=8000.0, young=1e6}]";

TEST(BuildMaterials, GivesOverlappingRegionsTheLastMaterial) {
  const auto body = build<2>(scene_with({two_regions}));
  ASSERT_EQ(body.regions.size(), 3U);
  std::vector<double> density(static_cast<std::size_t>(body.points.size()), 0.0);
  for (const auto& region : body.regions)
    for (const int s : region.points) density[static_cast<std::size_t>(s)] += region.density;

  for (Index s = 0; s < body.points.size(); ++s) {
    const double x = body.points.X(s, 0);
    const double y = body.points.X(s, 1);
    const double expected = x > 0.2 && y < 0.1 ? 8000.0 : x > 0.1 && x < 0.3 ? 3000.0 : 1000.0;
    ASSERT_EQ(density[static_cast<std::size_t>(s)], expected) << x << ", " << y;
  }
}

/// Nodes on an interface take their shares of both sides: no mass is lost or moved.
TEST(BuildMaterials, KeepsTheMassOfEveryRegion) {
  const auto body = build<2>(scene_with({two_regions}));

  const double expected = 8000.0 * 0.02 + 3000.0 * 0.03 + 1000.0 * 0.03;
  EXPECT_NEAR(body.mass.sum(), expected, 1e-12 * expected);
  for (Index q = 0; q < body.nodes(); ++q) {
    const double x = body.particles.X(q, 0);
    const double y = body.particles.X(q, 1);
    if (std::abs(x - 0.2) < 1e-9 && std::abs(y - 0.06) < 1e-9) {
      EXPECT_NEAR(body.mass[q], 0.5 * (8000.0 + 3000.0) * 4e-4, 1e-12);
    }
  }
}

TEST(BuildMaterials, RefusesARegionWithoutPoints) {
  const auto thin = scene_with({"material.region=[{box=[[0.201, 0.0], [0.202, 0.2]]}]"});
  EXPECT_THROW((void)build<2>(thin), InputError);
}

TEST(BuildConditions, RefusesABoundaryThereIsNot) {
  const auto scene = scene_with({"boundary=[{where=\"hole\", fixed=true}]"});
  try {
    (void)build<2>(scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("\"hole\""));
    EXPECT_THAT(error.what(), testing::HasSubstr("left (0, 0) to (0, 0.2)"));
    EXPECT_THAT(error.what(), testing::HasSubstr("edge3 (0, 0.2) to (0.4, 0.2)"));
  }
}

TEST(BuildConditions, RefusesToHoldAPartWithoutParticles) {
  const std::string gap = "body.tags=[{name=\"gap\", box=[[0.125, 0.2], [0.135, 0.2]]}]";
  EXPECT_NO_THROW((void)build<2>(scene_with({gap, "boundary=[{where=\"gap\", traction=1.0}]"})));
  EXPECT_THROW((void)build<2>(scene_with({gap, "boundary=[{where=\"gap\", fixed=true}]"})),
               InputError);
}

/// A box around an edge reaches beyond its corners; what is held there is still that edge.
TEST(BuildConditions, MirrorAtTheEdgeInABox) {
  const auto scene = scene_with({"body.tags=[{name=\"end\", box=[[0.39, -1.0], [0.41, 1.0]]}]",
                                 "boundary=[{where=\"end\", symmetry=true}]"});
  const auto body = build<2>(scene);
  const Patch<2>& right = *body.particles.find("right");
  ASSERT_EQ(body.constraints.fixed.size(), right.nodes.size());
  for (std::size_t k = 0; k < right.nodes.size(); ++k)
    EXPECT_EQ(body.constraints.fixed[k], 2 * Index{right.nodes[k]});
}

/// Uniform stress balances tractions over the whole boundary, by names, numbers or a box.
TEST(BuildConditions, LoadsOfWholeEdgesAreTheSameByAnyName) {
  const auto weights = [](const std::vector<std::string>& overrides) {
    const auto body = build<2>(scene_with(overrides));
    VectorField<2> sum = VectorField<2>::Zero(body.nodes(), 2);
    for (const Load& load : body.loads)
      for (std::size_t k = 0; k < load.dof.size(); ++k) sum.data()[load.dof[k]] += load.weight[k];
    return sum;
  };
  for (const char* formulation :
       {"formulation=stress-point", "formulation=variational", "formulation=consistent"}) {
    const auto named = weights({formulation, "boundary=[{where=\"right\", traction=1.0}]"});
    const auto numbered = weights({formulation, "boundary=[{where=\"edge2\", traction=1.0}]"});
    const auto boxed =
        weights({formulation, "body.tags=[{name=\"end\", box=[[0.4, 0.0], [0.4, 0.2]]}]",
                 "boundary=[{where=\"end\", traction=1.0}]"});
    EXPECT_EQ((named - numbered).norm(), 0.0) << formulation;
    EXPECT_EQ((named - boxed).norm(), 0.0) << formulation;
    EXPECT_NEAR(named.col(0).sum(), 0.2, 1e-13) << formulation;
  }
}

TEST(BuildConditions, RefusesTwoMotionsOfOneCorner) {
  const auto scene =
      scene_with({"boundary=[{where=\"left\", fixed=\"x\"}, "
                  "{where=\"top\", displacement={x=1e-3}}]"});
  EXPECT_THROW((void)build<2>(scene), InputError);
}

TEST(BuildConditions, HoldsACornerOnceThatTwoEdgesHold) {
  const auto body =
      build<2>(scene_with({"boundary=[{where=\"left\", fixed=true}, "
                           "{where=\"bottom\", fixed=true}]"}));
  EXPECT_EQ(body.constraints.fixed.size(), 2U * (11 + 21 - 1));
  for (const Index dof : body.constraints.fixed) EXPECT_EQ(body.inverse_mass.data()[dof], 0.0);
}

/// [[initial.region]] replaces what [initial] says; of overlapping boxes the last counts, and a
/// field that a region does not name stays.
TEST(BuildInitial, GivesRegionsTheirOwnStart) {
  const auto scene = scene_with(
      {"initial.displacement={gradient=[[0.1, 0.0], [0.0, 0.0]]}", "initial.velocity=[0.0, 2.0]",
       "initial.region=[{box=[[0.1, 0.0], [0.3, 0.2]], velocity=[1.0, 0.0]}, "
       "{box=[[0.2, 0.0], [0.4, 0.1]], displacement={constant=[0.0, 0.5]}, velocity=[3.0, 0.0]}]"});
  const auto body = build<2>(scene);

  const auto initial = build_initial<2>(scene, body);

  for (Index q = 0; q < body.nodes(); ++q) {
    const Vector<2> X = body.particles.X.row(q).transpose();
    const bool last = X[0] > 0.19 && X[1] < 0.11;
    const bool first = !last && X[0] > 0.09 && X[0] < 0.31;
    const Vector<2> u = last ? Vector<2>(0.0, 0.5) : Vector<2>(0.1 * X[0], 0.0);
    const Vector<2> v = last ? Vector<2>(3.0, 0.0) : first ? Vector<2>(1.0, 0.0) : Vector<2>(0, 2);
    ASSERT_EQ(Vector<2>(initial.displacement.row(q).transpose()), u) << X;
    ASSERT_EQ(Vector<2>(initial.velocity.row(q).transpose()), v) << X;
  }
}

TEST(BuildInitial, RefusesARegionWithoutParticles) {
  const auto scene =
      scene_with({"initial.region=[{box=[[0.201, 0.0], [0.202, 0.2]], velocity=[1.0, 0.0]}]"});
  const auto body = build<2>(scene);
  EXPECT_THROW((void)build_initial<2>(scene, body), InputError);
}

const std::string stretched = "initial.displacement={gradient=[[0.05, 0.01], [0.01, 0.02]]}";

/// Held particles stay where the initial displacement puts them, for good.
TEST(BuildConditions, HoldsParticlesAtTheirInitialDisplacement) {
  const auto scene = scene_with(
      {stretched, "boundary=[{where=\"outer\", held=true}]", "initial.velocity=[1.0, 1.0]"});
  const auto body = build<2>(scene);
  auto initial = build_initial<2>(scene, body);
  const VectorField<2> u = initial.displacement;
  auto state = make_state<2>(body, initial.displacement, initial.velocity);

  evaluate<2>(body, state);
  start<2>(body, state, 1e-5);
  for (int step = 0; step < 3; ++step) {
    advance<2>(body, state, 1e-5, state.time + 1e-5);
    evaluate<2>(body, state);
  }

  EXPECT_EQ(body.constraints.held.size(), 2U * 60);
  for (const Index dof : body.constraints.held) {
    EXPECT_EQ(state.u.data()[dof], u.data()[dof]);
    EXPECT_EQ(state.v.data()[dof], 0.0);
  }
  const Index inner = body.particles.frame->index({1, 1});
  EXPECT_NE(state.u(inner, 0), u(inner, 0));
}

std::string rim(int layers) {
  const double t = 0.02 * layers + 1e-6;
  return fmt::format(
      "body.tags=[{{name=\"rim1\", box=[[0.0, 0.0], [{0}, 0.2]]}}, "
      "{{name=\"rim2\", box=[[{1}, 0.0], [0.4, 0.2]]}}, "
      "{{name=\"rim3\", box=[[0.0, 0.0], [0.4, {0}]]}}, "
      "{{name=\"rim4\", box=[[0.0, {2}], [0.4, 0.2]]}}]",
      t, 0.4 - t, 0.2 - t);
}

const std::string hold_rim =
    "boundary=[{where=\"rim1\", held=true}, {where=\"rim2\", held=true}, "
    "{where=\"rim3\", held=true}, {where=\"rim4\", held=true}]";

/// A uniform stress that the supports balance must not set the body moving.
TEST(BuildInitial, RefusesAPrestressThatTheOperatorsDoNotBalance) {
  const auto start_of = [](const std::vector<std::string>& overrides) {
    const auto scene = scene_with(overrides);
    (void)build_initial<2>(scene, build<2>(scene));
  };
  const std::string variational = "formulation=variational";
  const std::string outer = "boundary=[{where=\"outer\", held=true}]";

  EXPECT_NO_THROW(start_of({stretched, outer}));
  EXPECT_THROW(start_of({stretched, outer, variational}), InputError);
  EXPECT_THROW(start_of({stretched, rim(1), hold_rim, variational}), InputError);
  EXPECT_NO_THROW(start_of({stretched, rim(4), hold_rim, variational}));
  // (λ + 2μ) and λ times the strain, λ = μ = 0.8 MPa: its own stress as loads.
  const std::string pulled = "initial.displacement={gradient=[[0.05, 0.0], [0.0, 0.0]]}";
  const std::string loads =
      "boundary=[{where=\"left\", traction=120e3}, {where=\"right\", traction=120e3}, "
      "{where=\"bottom\", traction=40e3}, {where=\"top\", traction=40e3}]";
  EXPECT_NO_THROW(start_of({pulled, loads}));
  EXPECT_THROW(start_of({pulled, loads, variational}), InputError);
  // Let go at one side, the body is meant to move.
  EXPECT_NO_THROW(start_of({stretched, "boundary=[{where=\"left\", held=true}]", variational}));
  // Moved supports and a small region beside equilibrium do not hide it.
  const std::string bare =
      "boundary=[{where=\"left\", fixed=\"x\"}, "
      "{where=\"right\", displacement={x=0.02}}, "
      "{where=\"bottom\", fixed=\"y\"}, {where=\"top\", fixed=\"y\"}]";
  const std::string along = "initial.displacement={gradient=[[0.05, 0.0], [0.0, 0.0]]}";
  const std::string touch =
      "initial.region=[{box=[[0.2, 0.1], [0.2, 0.1]], displacement=[0.0, 0.0]}]";
  EXPECT_THROW(start_of({along, bare, touch, variational}), InputError);
  EXPECT_NO_THROW(start_of({along, bare, touch}));
}

/// A normal traction on an edge is its length times the pressure in all.
TEST(BuildConditions, LoadsAnEdgeWithItsWholeLength) {
  const auto body = build<2>(scene_with({"boundary=[{where=\"top\", traction=1.0}]"}));
  ASSERT_EQ(body.loads.size(), 1U);
  double x = 0.0;
  double y = 0.0;
  for (std::size_t k = 0; k < body.loads[0].dof.size(); ++k)
    (body.loads[0].dof[k] % 2 == 0 ? x : y) += body.loads[0].weight[k];

  EXPECT_NEAR(x, 0.0, 1e-15);
  EXPECT_NEAR(y, 0.4, 1e-14);
}

/// κ = (4/3) E/(1 − ν²) in plane strain, (4/3) E in plane stress; on squares γ = ±1/4.
TEST(BuildStabiliser, GivesCellsTheirBendingStiffness) {
  const auto strain = build<2>(scene_with({}));
  const auto stress = build<2>(scene_with({"material.assumption=stress"}));

  EXPECT_NEAR(stabiliser_matrix<2>(strain).coeff(0, 0), 4.0 / 3.0 * 2e6 / (1.0 - 0.0625) / 16.0,
              1e-6);
  EXPECT_NEAR(stabiliser_matrix<2>(stress).coeff(0, 0), 4.0 / 3.0 * 2e6 / 16.0, 1e-6);
}

TEST(BuildStabiliser, IsProportionalToItsCoefficient) {
  const auto one = build<2>(scene_with({"stabiliser.kind=pair", "stabiliser.coefficient=0.1"}));
  const auto two = build<2>(scene_with({"stabiliser.kind=pair", "stabiliser.coefficient=0.2"}));

  const SparseMatrix difference = two.stiffness - 2.0 * one.stiffness;
  EXPECT_GT(one.stiffness.norm(), 0.0);
  EXPECT_LE(difference.norm(), 1e-14 * two.stiffness.norm());
}

TEST(BuildParticles, RefusesABodyThatDoesNotFitIntoMemory) {
  const auto scene = scene_with({"body.spacing=1e-7"});
  try {
    (void)build_particles<2>(scene);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("memory"));
    EXPECT_THAT(error.what(), testing::HasSubstr("choose a spacing above"));
  }
}

/// A law that is not linear keeps two strains a point to follow its step by, unless the step is
/// given: those of the last estimate and of the last bound.
TEST(OperatorBytes, CountTheFieldsThatFollowTheStep) {
  const auto bytes = [](const std::vector<std::string>& overrides) {
    return operator_bytes(scene_with(overrides), 1e6);
  };
  const double linear = bytes({"material.law=linear-elastic"});

  EXPECT_EQ(bytes({"material.law=neo-hookean"}) - linear, 1e6 * 2 * 4 * 4);
  EXPECT_EQ(bytes({"material.law=neo-hookean", "time.step=1e-6"}), linear);
}

TEST(BuildInitial, AddsConstantAndGradient) {
  const auto scene =
      scene_with({"initial.velocity={constant=[1.0, 2.0], gradient=[[0.5, 0.0], [-1.0, 2.0]]}"});
  const auto body = build<2>(scene);

  const auto initial = build_initial<2>(scene, body);

  for (Index q = 0; q < body.nodes(); ++q) {
    const double x = body.particles.X(q, 0);
    const double y = body.particles.X(q, 1);
    EXPECT_NEAR(initial.velocity(q, 0), 1.0 + 0.5 * x, 1e-15);
    EXPECT_NEAR(initial.velocity(q, 1), 2.0 - x + 2.0 * y, 1e-15);
  }
  EXPECT_EQ(initial.displacement.cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace tlsph

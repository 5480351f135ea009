/// The central difference against closed forms, and what it does to held and moved particles.

#include "tlsph/dynamics/state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/core/error.hpp"
#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

using test::cells_of;

template <int D>
VectorField<D> zero(const Discretisation<D>& body) {
  return VectorField<D>::Zero(body.nodes(), D);
}

/// Started and ready for its first step.
template <int D>
State<D> started(const Discretisation<D>& body, const VectorField<D>& u, const VectorField<D>& v,
                 double dt) {
  State<D> state = make_state<D>(body, u, v);
  evaluate<D>(body, state);
  start<D>(body, state, dt);
  return state;
}

template <int D>
void step(const Discretisation<D>& body, State<D>& state, double dt) {
  evaluate<D>(body, state);
  advance<D>(body, state, dt, state.time + dt);
}

/// One cell held at one end is a mass on a spring: u_n = u_0 cos nθ with 2 sin θ/2 = ω Δt.
TEST(CentralDifference, SwingsAMassOnASpringAtItsDiscreteFrequency) {
  auto body = cells_of<1>(1);
  test::hold<1>(body, 0);
  const double modulus = tangent<1>(body.regions[0].law, Tensor<1>::Zero())(0, 0);
  const double omega = std::sqrt(modulus / body.spacing / body.mass[1]);
  const double dt = 0.7 / omega;
  auto u = zero<1>(body);
  u(1, 0) = 1e-4;
  State<1> state = started<1>(body, u, zero<1>(body), dt);

  for (int n = 0; n < 50; ++n) step<1>(body, state, dt);

  const double theta = 2.0 * std::asin(0.5 * omega * dt);
  EXPECT_NEAR(state.u(1, 0), 1e-4 * std::cos(50 * theta), 1e-16);
  EXPECT_EQ(state.u(0, 0), 0.0);
  EXPECT_EQ(state.step, 50);
}

/// Uniform acceleration is exact, also when the steps change on the way.
TEST(CentralDifference, FallsFreelyWithStepsOfAnyLength) {
  auto body = cells_of<2>(2);
  body.body_force = Vector<2>(1.0, -9.81);
  const VectorField<2> v = Vector<2>(0.3, 0.2).transpose().replicate(body.nodes(), 1);
  State<2> state = started<2>(body, zero<2>(body), v, 1e-5);

  for (const double dt : {1e-5, 2e-5, 5e-6, 5e-6, 3e-5}) step<2>(body, state, dt);

  const double t = 7e-5;
  for (Index q = 0; q < body.nodes(); ++q) {
    EXPECT_NEAR(state.u(q, 0), 0.3 * t + 0.5 * t * t, 1e-16);
    EXPECT_NEAR(state.u(q, 1), 0.2 * t - 0.5 * 9.81 * t * t, 1e-16);
  }
}

TEST(CentralDifference, PutsMovedParticlesOnTheirCurve) {
  auto body = cells_of<1>(3);
  test::hold<1>(body, 0);
  const Curve curve = RampCurve{1e-3, 1e-3, true};
  test::move<1>(body, 3, curve);
  State<1> state = started<1>(body, zero<1>(body), zero<1>(body), 1e-5);

  for (int n = 0; n < 20; ++n) {
    step<1>(body, state, 1e-5);
    ASSERT_EQ(state.u(3, 0), value(curve, state.time));
    ASSERT_EQ(state.u(0, 0), 0.0);
  }
}

TEST(CentralDifference, AdvancesWithTheNextVelocity) {
  auto body = cells_of<2>(2);
  test::hold<2>(body, 0);
  test::move<2>(body, 5, RampCurve{1e-4, 1e-3, false});
  body.body_force = Vector<2>(0.0, -9.81);
  auto u = zero<2>(body);
  u(8, 0) = 1e-4;
  State<2> state = started<2>(body, u, zero<2>(body), 1e-5);
  evaluate<2>(body, state);
  Eigen::VectorXd expected(state.v.size());
  for (Index dof = 0; dof < expected.size(); ++dof)
    expected[dof] = next_velocity<2>(body, state, 2e-5, dof);

  advance<2>(body, state, 2e-5, 2e-5);

  for (Index dof = 0; dof < expected.size(); ++dof)
    EXPECT_NEAR(state.v.data()[dof], expected[dof], 1e-15 * (1.0 + std::abs(expected[dof])));
}

TEST(MakeState, StartsHeldAndMovedParticlesWhereTheyAreToBe) {
  auto body = cells_of<1>(2);
  test::hold<1>(body, 0);
  test::move<1>(body, 2, TableCurve{{0.0, 1.0}, {0.25, 1.25}, {}});
  const VectorField<1> one = VectorField<1>::Ones(3, 1);

  const State<1> state = make_state<1>(body, one, one);

  EXPECT_EQ(state.u(0, 0), 0.0);
  EXPECT_EQ(state.v(0, 0), 0.0);
  EXPECT_EQ(state.u(1, 0), 1.0);
  EXPECT_EQ(state.u(2, 0), 0.25);
  EXPECT_NEAR(state.v(2, 0), 1.0, 1e-15);
}

/// Traction on a free bar is its load at the end, and at the held end the force of what it carries.
TEST(Evaluate, AddsLoadsToTheInternalForces) {
  auto body = cells_of<1>(2);
  const Patch<1>* right = body.particles.find("right");
  ASSERT_NE(right, nullptr);
  body.loads.push_back(normal_traction<1>(*right, RampCurve{500.0, 2.0, false}));
  State<1> state = make_state<1>(body, zero<1>(body), zero<1>(body));
  state.time = 1.0;

  evaluate<1>(body, state);

  EXPECT_EQ(state.f(0, 0), 0.0);
  EXPECT_EQ(state.f(1, 0), 0.0);
  EXPECT_NEAR(state.f(2, 0), 250.0, 1e-12);
}

TEST(Evaluate, NamesTimeAndPointOfALostDeformation) {
  const auto body = cells_of<1>(5, LawName::neo_hookean);
  auto u = zero<1>(body);
  u.bottomRows(3).setConstant(-1.1 * body.spacing);  // cell 2, at 0.05 m, is turned inside out
  State<1> state = make_state<1>(body, u, zero<1>(body));
  state.time = 0.125;
  state.step = 7;

  try {
    evaluate<1>(body, state);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.time(), 0.125);
    EXPECT_EQ(error.particle(), 2);
    EXPECT_THAT(error.what(), testing::HasSubstr("0.05"));
    EXPECT_THAT(error.what(), testing::HasSubstr("step 7"));
  }
}

/// Its stress is a polynomial and stays finite: det F itself has to stop the run. Cell 2 of 4 is
/// turned inside out, its left node pushed past its right one.
TEST(Evaluate, NamesAnInvertedPointOfALawThatStaysFinite) {
  const auto body = cells_of<1>(4, LawName::st_venant_kirchhoff);
  auto u = zero<1>(body);
  u(2, 0) = 0.03;
  State<1> state = make_state<1>(body, u, zero<1>(body));

  try {
    evaluate<1>(body, state);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.particle(), 2);
    EXPECT_TRUE(state.P.allFinite());
  }
}

TEST(Evaluate, LetsSmallStrainsPassWhateverDetFIs) {
  const auto body = cells_of<1>(4, LawName::linear_elastic);
  auto u = zero<1>(body);
  u(2, 0) = 0.03;
  State<1> state = make_state<1>(body, u, zero<1>(body));

  EXPECT_NO_THROW(evaluate<1>(body, state));
}

TEST(Evaluate, NamesAPointThatIsNotFinite) {
  const auto body = cells_of<2>(2);
  auto u = zero<2>(body);
  u(8, 1) = std::numeric_limits<double>::quiet_NaN();
  State<2> state = make_state<2>(body, u, zero<2>(body));

  try {
    evaluate<2>(body, state);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.particle(), 3);
  }
}

}  // namespace
}  // namespace tlsph

/// The counter-example's sums: by hand, by its laws, and against the reference configuration.

#include "tlsph/contrast/updated_lagrangian.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tlsph/core/error.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/operators/gradients.hpp"

namespace tlsph {
namespace {

/// Unit masses at x with density 1, the stresses given; cubic spline of radius 2.
CurrentBody<1> unit_body(Index count) {
  return {CubicSpline{}, 2.0, {3.0, 0.0}, ScalarField::Ones(count), VectorField<1>::Ones(count, 1)};
}

CurrentState<1> at_rest(std::initializer_list<double> x, std::initializer_list<double> stress) {
  CurrentState<1> state;
  state.x = Eigen::Map<const VectorField<1>>(x.begin(), static_cast<Index>(x.size()));
  state.v = VectorField<1>::Zero(state.x.rows(), 1);
  state.density = ScalarField::Ones(state.x.rows());
  state.stress = Eigen::Map<const TensorField<1>>(stress.begin(), state.x.rows());
  return state;
}

/// The cubic spline of radius 2 has dW/dr = −1/2 at 1 and −1/8 at 3/2 in one dimension.
TEST(CurrentSums, AreTheForcesWorkedOutByHand) {
  const auto state = at_rest({0.0, 1.0, 2.5}, {1.0, 2.0, 4.0});

  const VectorField<1> a = acceleration<1>(unit_body(3), state);

  EXPECT_NEAR(a(0), 0.5 * (1.0 + 2.0), 1e-15);
  EXPECT_NEAR(a(1), -0.5 * (1.0 + 2.0) + 0.125 * (2.0 + 4.0), 1e-15);
  EXPECT_NEAR(a(2), -0.125 * (2.0 + 4.0), 1e-15);
}

/// v_{1/2} = Δt a; dv/dx of the first is (v₂ − v₁)/2, and stress and density follow it.
TEST(CurrentSums, TakeAStepWorkedOutByHand) {
  const CurrentBody<1> body = unit_body(2);
  auto state = at_rest({0.0, 1.0}, {1.0, 1.0});
  constexpr double dt = 0.01;

  advance<1>(body, state, dt);

  EXPECT_NEAR(state.v(0), dt, 1e-15);
  EXPECT_NEAR(state.v(1), -dt, 1e-15);
  EXPECT_NEAR(state.x(0), dt * dt, 1e-15);
  const double L = 0.5 * (-dt - dt);
  EXPECT_NEAR(state.density[0], 1.0 - dt * L, 1e-15);
  EXPECT_NEAR(state.stress(1), 1.0 + dt * 3.0 * L, 1e-15);
  EXPECT_NEAR(kinetic_energy<1>(body, state), dt * dt, 1e-18);
}

TEST(CurrentSums, LeaveHeldParticlesWhereTheyAre) {
  CurrentBody<1> body = unit_body(2);
  body.motion(0) = 0.0;
  auto state = at_rest({0.0, 1.0}, {1.0, 1.0});

  advance<1>(body, state, 0.01);

  EXPECT_EQ(state.x(0), 0.0);
  EXPECT_LT(state.x(1), 1.0);
}

TEST(CurrentSums, NameTheParticleThatIsLost) {
  auto state = at_rest({0.0, 1.0}, {-1.0, -1.0});
  state.v(0) = -1.0;
  state.v(1) = 1.0;
  try {
    advance<1>(unit_body(2), state, 10.0);
    FAIL() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_EQ(error.particle(), 0);
    EXPECT_THAT(error.what(), testing::HasSubstr("density"));
  }
}

/// A cloud of particles of differing masses and densities under random symmetric stress.
struct Cloud {
  CurrentBody<2> body;
  CurrentState<2> state;
};

Cloud random_cloud() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Particles<2> particles =
      make_lattice<2>(Shape<2>{Box<2>{Vector<2>::Zero(), Vector<2>::Constant(1.0)}}, 0.1);
  Cloud cloud;
  const Index N = particles.size();
  cloud.body = {WendlandC2{}, 0.27, {2.0, 1.0}, ScalarField(N), VectorField<2>::Ones(N, 2)};
  cloud.state.x = particles.X;
  cloud.state.v = VectorField<2>(N, 2);
  cloud.state.density = ScalarField(N);
  cloud.state.stress = TensorField<2>(N, 4);
  for (Index q = 0; q < N; ++q) {
    cloud.body.mass[q] = 0.01 * (1.0 + 0.3 * number(random));
    cloud.state.density[q] = 1.0 + 0.3 * number(random);
    for (int a = 0; a < 2; ++a) {
      cloud.state.x(q, a) += 0.03 * number(random);
      cloud.state.v(q, a) = number(random);
    }
    const double shear = number(random);
    cloud.state.stress.row(q) << number(random), shear, shear, number(random);
  }
  return cloud;
}

TEST(CurrentSums, KeepLinearMomentum) {
  Cloud cloud = random_cloud();
  const auto momentum = [&] { return Vector<2>(cloud.state.v.transpose() * cloud.body.mass); };
  const Vector<2> before = momentum();

  for (int step = 0; step < 20; ++step) advance<2>(cloud.body, cloud.state, 1e-3);

  EXPECT_NEAR((momentum() - before).norm(), 0.0, 1e-14);
}

/// Pressure pushes along the line between two particles, so it turns nothing; shear stress may.
TEST(CurrentSums, KeepAngularMomentumUnderPressure) {
  Cloud cloud = random_cloud();
  for (Index q = 0; q < cloud.state.x.rows(); ++q) {
    const double pressure = cloud.state.stress(q, 0);
    cloud.state.stress.row(q) << pressure, 0.0, 0.0, pressure;
  }

  const VectorField<2> a = acceleration<2>(cloud.body, cloud.state);

  double moment = 0.0, scale = 0.0;
  for (Index q = 0; q < a.rows(); ++q) {
    const auto x = cloud.state.x.row(q);
    moment += cloud.body.mass[q] * (x(0) * a(q, 1) - x(1) * a(q, 0));
    scale += cloud.body.mass[q] * a.row(q).norm();
  }
  EXPECT_NEAR(moment, 0.0, 1e-14 * scale);
}

/// A uniform stress turns with a body that spins: dσ/dt = wσ − σw.
TEST(CurrentSums, TurnTheStressWithTheBody) {
  Cloud cloud = random_cloud();
  CurrentState<2>& state = cloud.state;
  const Particles<2> particles =
      make_lattice<2>(Shape<2>{Box<2>{Vector<2>::Zero(), Vector<2>::Constant(1.0)}}, 0.1);
  state.x = particles.X;
  state.density.setOnes();
  cloud.body.mass.setConstant(0.01);
  cloud.body.motion.setZero();
  state.stress = TensorField<2>::Zero(state.x.rows(), 4);
  state.stress.col(0).setOnes();
  for (Index q = 0; q < state.x.rows(); ++q) state.v.row(q) << -state.x(q, 1), state.x(q, 0);

  advance<2>(cloud.body, state, 1e-6);

  const Index middle = state.x.rows() / 2;
  const double spin = state.stress(middle, 1) / 1e-6;  // 1 but for the error of the bare kernel sum
  EXPECT_NEAR(spin, 1.0, 0.05);
  EXPECT_NEAR(state.stress(middle, 2), state.stress(middle, 1), 1e-12);
  EXPECT_NEAR(state.stress(middle, 0), 1.0, 1e-11);
}

/// In the reference state the sums are those of the total-Lagrangian form without correction: with
/// the difference gradient G (Bonet & Lok, (40)) its adjoint is −GᵀV σ, and L = G v.
template <int D>
void expect_total_lagrangian_sums() {
  const AnyKernel kernel = CubicSpline{};
  Particles<D> particles =
      make_lattice<D>(Shape<D>{Box<D>{Vector<D>::Zero(), Vector<D>::Constant(1.0)}}, 0.1);
  particles = jittered<D>(std::move(particles), 0.2, 5);
  const Index N = particles.size();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  constexpr double density = 1000.0;
  constexpr double h = 0.24;
  CurrentBody<D> body{kernel, h, {2.0, 1.0}, density * particles.V, VectorField<D>::Zero(N, D)};
  CurrentState<D> state;
  state.x = particles.X;
  state.v = VectorField<D>::NullaryExpr(N, D, [&] { return number(random); });
  state.density = ScalarField::Constant(N, density);
  state.stress = TensorField<D>::NullaryExpr(N, D * D, [&] { return number(random); });
  if constexpr (D == 2) state.stress.col(2) = state.stress.col(1);

  const VectorOperator<D> G =
      collocated_gradient<D>(kernel, h, particles.X, particles.V, Correction::none);
  VectorField<D> force(N, D);
  G.negative_adjoint(particles.V).divergence(state.stress, force);
  TensorField<D> L(N, D * D);
  G.gradient(state.v, L);

  const VectorField<D> a = acceleration<D>(body, state);
  for (Index q = 0; q < N; ++q)
    for (int i = 0; i < D; ++i)
      ASSERT_NEAR(body.mass[q] * a(q, i), force(q, i), 1e-12 * force.cwiseAbs().maxCoeff());

  constexpr double dt = 1e-3;
  advance<D>(body, state, dt);
  for (Index q = 0; q < N; ++q) {
    const double divergence = tensor_at<D>(L, q).trace();
    ASSERT_NEAR(state.density[q], density * (1.0 - dt * divergence), 1e-9);
  }
}

TEST(CurrentSums, AreThoseOfTheReferenceStateWithoutCorrection) {
  expect_total_lagrangian_sums<1>();
  expect_total_lagrangian_sums<2>();
}

}  // namespace
}  // namespace tlsph

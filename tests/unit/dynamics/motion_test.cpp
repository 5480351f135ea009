/// Formulations stepped through nothing but what they show of their motion.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/materials/kinematics.hpp"
#include "unit/dynamics/bodies.hpp"
#include "unit/dynamics/displacement_motion.hpp"

namespace tlsph {
namespace {

/// One step of the classical Runge–Kutta method, of order four.
template <EquationOfMotion Motion>
void runge_kutta(const Motion& motion, double t, double dt, typename Motion::State& state) {
  constexpr std::array<double, 4> at = {0.0, 0.5, 0.5, 1.0}, share = {1.0, 2.0, 2.0, 1.0};
  const typename Motion::State before = state;
  typename Motion::Rate rate;
  for (std::size_t k = 0; k < at.size(); ++k) {
    typename Motion::State stage = before;
    if (k > 0) motion.add(at[k] * dt, rate, stage);
    motion.rate(t + at[k] * dt, stage, rate);
    motion.add(share[k] / 6.0 * dt, rate, state);
  }
}

/// Momentum p of the nodes and displacement gradient H of the points, each an unknown of its own:
/// ṗ = D P(H), Ḣ = G M⁻¹ p.
template <int D>
struct MomentumMotion {
  const Discretisation<D>& body;

  struct State {
    VectorField<D> p;
    TensorField<D> H;
  };
  using Rate = State;

  void rate(double /*t*/, State& state, Rate& out) const {
    TensorField<D> P = state.H;
    for (Index s = 0; s < P.rows(); ++s)
      Eigen::Map<Tensor<D>>(P.data() + s * D * D) =
          pk1<D>(body.regions.front().law, tensor_at<D>(state.H, s));
    out.p.setZero(state.p.rows(), D);
    out.H.setZero(state.H.rows(), D * D);
    body.divergence.divergence(P, out.p);
    out.p = out.p.cwiseProduct((body.inverse_mass.array() > 0.0).template cast<double>().matrix());
    body.gradient.gradient(body.inverse_mass.cwiseProduct(state.p), out.H);
  }
  void add(double h, const Rate& rate, State& state) const {
    state.p += h * rate.p;
    state.H += h * rate.H;
  }
  [[nodiscard]] double energy(const State& state) const {
    double sum = 0.5 * body.inverse_mass.cwiseProduct(state.p).cwiseProduct(state.p).sum();
    for (Index s = 0; s < state.H.rows(); ++s)
      sum +=
          body.points.V[s] * tlsph::energy<D>(body.regions.front().law, tensor_at<D>(state.H, s));
    return sum;
  }
};
static_assert(EquationOfMotion<MomentumMotion<1>> && EquationOfMotion<MomentumMotion<2>>);

/// One cell held at one end is a mass on a spring: u = u₀ cos ωt, to order four.
TEST(Motion, OfAMassOnASpringIsItsSwing) {
  auto body = test::cells_of<1>(1);
  test::hold<1>(body, 0);
  const double modulus = tangent<1>(body.regions[0].law, Tensor<1>::Zero())(0, 0);
  const double omega = std::sqrt(modulus / body.spacing / body.mass[1]);
  const auto error_of = [&](int steps) {
    VectorField<1> u = VectorField<1>::Zero(2, 1);
    u(1, 0) = 1e-4;
    State<1> state = make_state<1>(body, u, VectorField<1>::Zero(2, 1));
    const double dt = 1.0 / (omega * steps);
    for (int n = 0; n < steps; ++n) runge_kutta(DisplacementMotion<1>{body}, n * dt, dt, state);
    return std::abs(state.u(1, 0) / 1e-4 - std::cos(1.0));
  };

  EXPECT_LE(error_of(20), 1e-7);
  EXPECT_NEAR(std::log2(error_of(10) / error_of(20)), 4.0, 0.2);
}

TEST(Motion, FollowsTheCurveOfAMovedNode) {
  auto body = test::cells_of<1>(3);
  const Curve curve = RampCurve{1e-3, 1e-3, true};
  test::move<1>(body, 3, curve);
  const DisplacementMotion<1> motion{body};
  State<1> state = make_state<1>(body, VectorField<1>::Zero(4, 1), VectorField<1>::Zero(4, 1));
  DisplacementMotion<1>::Rate rate;

  motion.rate(4e-4, state, rate);

  EXPECT_EQ(state.u(3, 0), value(curve, 4e-4));
  EXPECT_EQ(rate.u(3, 0), tlsph::rate(curve, 4e-4));
  EXPECT_EQ(rate.v(3, 0), 0.0);
}

/// H = G u commutes with every step, so a formulation of {p, H} and one of {u, v} are the same
/// motion, and have the same energy.
TEST(Motion, OfMomentumAndGradientIsThatOfDisplacementAndVelocity) {
  auto body = test::cells_of<2>(3, LawName::neo_hookean);
  for (const Index dof : {0, 1, 3}) test::hold<2>(body, dof);
  VectorField<2> v = VectorField<2>::Zero(body.nodes(), 2);
  for (Index q = 0; q < body.nodes(); ++q)
    v.row(q) << std::sin(2.0 * double(q)), std::cos(double(q));
  v = v.cwiseProduct((body.inverse_mass.array() > 0.0).cast<double>().matrix());
  const double dt = 2e-5;
  State<2> displaced = make_state<2>(body, VectorField<2>::Zero(body.nodes(), 2), v);
  MomentumMotion<2>::State moving{v, TensorField<2>::Zero(body.points.size(), 4)};
  moving.p.array().colwise() *= body.mass.array();

  for (int n = 0; n < 40; ++n) {
    runge_kutta(DisplacementMotion<2>{body}, n * dt, dt, displaced);
    runge_kutta(MomentumMotion<2>{body}, n * dt, dt, moving);
  }
  evaluate<2>(body, displaced);

  ASSERT_GT(displaced.H.cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_LE((moving.H - displaced.H).cwiseAbs().maxCoeff(), 1e-13);
  const double energy = DisplacementMotion<2>{body}.energy(displaced);
  EXPECT_NEAR(MomentumMotion<2>{body}.energy(moving), energy, 1e-12 * energy);
}

}  // namespace
}  // namespace tlsph

/// The step of a body that deforms: its bound is one, and it is followed through a compression.
#include "tlsph/stepping/adaptive_step.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <any>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>

#include "tlsph/materials/any_law.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

using test::cells_of;

template <int D>
State<D> stretched(const Discretisation<D>& body, double factor, double disorder) {
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> random(-disorder * body.spacing, disorder * body.spacing);
  VectorField<D> u = VectorField<D>::Zero(body.nodes(), D);
  u.col(0) = (factor - 1.0) * body.particles.X.col(0);
  for (Index k = 0; k < u.size(); ++k) u.data()[k] += random(bits);
  State<D> state = make_state<D>(body, u, VectorField<D>::Zero(body.nodes(), D));
  evaluate<D>(body, state);
  return state;
}

template <class Dimension>
class Follower : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>>;
TYPED_TEST_SUITE(Follower, Dimensions);

TYPED_TEST(Follower, BoundsTheCriticalStepAtAnyState) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(8, LawName::neo_hookean);
  const AdaptiveStep<D> follower(body, stretched<D>(body, 1.0, 0.0), 0.9);

  for (const double factor : {0.2, 0.4, 0.7, 0.95, 1.0, 1.1, 1.5, 3.0})
    for (const double disorder : {0.0, 0.04}) {
      const State<D> state = stretched<D>(body, factor, disorder);
      const double limit = critical_step<D>(body, state).dt;
      const double bound = follower.bound(state);

      EXPECT_LE(bound, 1.002 * limit) << factor << ' ' << disorder;
      if (factor < 1.0) {
        EXPECT_GE(bound, 0.5 * limit) << factor << ' ' << disorder;
      }
    }
}

/// Pressed at a hundredth of the speed of sound a step; returns the largest Δt over the limit.
template <int D>
double worst_share(const Discretisation<D>& body, AdaptiveStep<D>& follower, State<D>& state,
                   double speed, double until) {
  double worst = 0.0;
  double factor = 1.0;
  double dt = follower.step();
  const double length = body.particles.X.col(0).maxCoeff();
  while (factor > until) {
    if (follower.update(state)) dt = follower.step();
    worst = std::max(worst, dt / critical_step<D>(body, state).dt);
    factor -= speed * body.wave_speed() * dt / length;
    state.u.col(0) = (factor - 1.0) * body.particles.X.col(0);
    ++state.step;
    state.last_dt = dt;
    evaluate<D>(body, state);
  }
  return worst;
}

TYPED_TEST(Follower, StaysBelowTheLimitThroughACompressionToAFifth) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(6, LawName::neo_hookean);
  for (const double speed : {0.01, 0.2}) {
    State<D> state = stretched<D>(body, 1.0, 0.0);
    AdaptiveStep<D> follower(body, state, 0.95);

    const double worst = worst_share<D>(body, follower, state, speed, 0.2);

    EXPECT_LE(worst, 0.97) << speed;
    EXPECT_GE(worst, 0.9) << speed;
    // Ten at any time and one in 200 steps, beside the first.
    EXPECT_LE(200 * follower.estimates(), 2200 + state.step) << speed;
  }
}

/// Down to a half, back and beyond: what is stiff once may be so again.
TYPED_TEST(Follower, NeverLengthensTheStepAgain) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(5, LawName::neo_hookean);
  State<D> state = stretched<D>(body, 1.0, 0.0);
  AdaptiveStep<D> follower(body, state, 0.9);
  double dt = follower.step();
  const double first = dt;
  int falls = 0;
  for (state.step = 1; state.step <= 400; ++state.step) {
    const double factor = 1.0 - 0.3 * std::sin(0.03 * static_cast<double>(state.step));
    state.u.col(0) = (factor - 1.0) * body.particles.X.col(0);
    state.last_dt = dt;
    evaluate<D>(body, state);
    if (!follower.update(state)) continue;
    EXPECT_LE(follower.step(), 0.97 * dt);
    EXPECT_LE(follower.step(), 0.93 * critical_step<D>(body, state).dt);
    dt = follower.step();
    ++falls;
  }
  EXPECT_LT(dt, 0.8 * first);
  EXPECT_LE(falls, 25);
}

TYPED_TEST(Follower, SeesNoDeformationInATurn) {
  if constexpr (TypeParam::value == 2) {
    const auto body = cells_of<2>(5, LawName::neo_hookean);
    State<2> state = stretched<2>(body, 1.1, 0.02);
    const VectorField<2> x = body.particles.X + state.u;
    AdaptiveStep<2> follower(body, state, 0.9);
    for (state.step = 1; state.step <= 300; ++state.step) {
      const double angle = 0.05 * static_cast<double>(state.step);
      Tensor<2> R;
      R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      state.u = x * R.transpose() - body.particles.X;
      state.last_dt = follower.step();
      evaluate<2>(body, state);
      EXPECT_FALSE(follower.update(state));
      EXPECT_NEAR(follower.bound(state), follower.critical().dt, 1e-5 * follower.critical().dt);
    }
    EXPECT_EQ(follower.bounds(), 0);
  }
}

TYPED_TEST(Follower, LooksRarelyAtABodyAtRest) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(4, LawName::neo_hookean);
  State<D> state = stretched<D>(body, 1.0, 0.0);
  AdaptiveStep<D> follower(body, state, 0.9);

  for (state.step = 1; state.step <= 1600; ++state.step) EXPECT_FALSE(follower.update(state));

  EXPECT_LE(follower.checks(), 110);
  EXPECT_EQ(follower.bounds(), 0);
  EXPECT_EQ(follower.estimates(), 1);
}

TYPED_TEST(Follower, LooksOutOfTurnAtABodyThatIsStruck) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(4, LawName::neo_hookean);
  const double spacing = body.spacing;
  State<D> state = stretched<D>(body, 1.0, 0.0);
  AdaptiveStep<D> follower(body, state, 0.9);
  const auto step = [&](double path) {
    follower.moved_by(path);
    ++state.step;
    state.last_dt = 1e-5;
    return follower.update(state);
  };
  // Vibrates until looks have become rare, then rests in between.
  for (int n = 0; n < 200; ++n) (void)step(1e-4 * spacing);
  long last = follower.checks();
  while (follower.checks() == last) (void)step(1e-4 * spacing);
  last = follower.checks();

  state.u.col(0) = -0.05 * body.particles.X.col(0);
  evaluate<D>(body, state);
  const bool changed = step(0.05 * spacing);

  EXPECT_EQ(follower.checks(), last + 1);
  EXPECT_TRUE(changed);
  EXPECT_LT(follower.step(), 0.93 * critical_step<D>(body, state).dt);
}

/// All that a follower visits, by name, to another one.
template <int D>
void hand_over(AdaptiveStep<D>& from, AdaptiveStep<D>& to) {
  std::map<std::string, std::any> values;
  from.visit([&](const std::string& name, const auto& value) {
    EXPECT_TRUE(values.emplace(name, value).second) << name;
  });
  to.visit([&]<class Value>(const std::string& name, Value& value) {
    value = std::any_cast<Value>(values.at(name));
  });
}

TYPED_TEST(Follower, GoesOnFromItsValuesAsIfItHadNotStopped) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(5, LawName::neo_hookean);
  State<D> state = stretched<D>(body, 1.0, 0.0);
  AdaptiveStep<D> follower(body, state, 0.95);
  AdaptiveStep<D> resumed(body, state, 0.95);
  (void)worst_share<D>(body, follower, state, 0.05, 0.6);

  hand_over<D>(follower, resumed);

  for (int n = 0; n < 200; ++n) {
    state.u.col(0) *= 1.004;
    ++state.step;
    evaluate<D>(body, state);
    EXPECT_EQ(follower.update(state), resumed.update(state));
    EXPECT_EQ(follower.step(), resumed.step());
  }
  EXPECT_EQ(resumed.checks(), follower.checks());
  EXPECT_EQ(resumed.bounds(), follower.bounds());
  EXPECT_EQ(resumed.estimates(), follower.estimates());
}

/// Every law, in plane stress with a negative λ too.
template <int D>
std::vector<AnyLaw<D>> nonlinear_laws() {
  std::vector<AnyLaw<D>> laws;
  for (const Assumption assumption : {Assumption::strain, Assumption::stress}) {
    laws.push_back(make_law<D>(LawName::neo_hookean, assumption, test::young, 0.3));
    laws.push_back(make_law<D>(LawName::st_venant_kirchhoff, assumption, test::young, 0.3));
  }
  laws.push_back(make_law<D>(LawName::neo_hookean, Assumption::stress, test::young, -0.2));
  return laws;
}

/// U of F = R U, less one.
template <int D>
Tensor<D> stretch(const State<D>& state, Index point) {
  const Tensor<D> F = deformation_gradient<D>(tensor_at<D>(state.H, point));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> C(F.transpose() * F);
  return C.operatorSqrt() - Eigen::Matrix<double, D, D>::Identity();
}

/// max λ_max(A(U) − A(U₀)) by Gershgorin's discs, tangent by tangent.
template <int D>
double stiffening(const Discretisation<D>& body, const State<D>& state, const State<D>& before) {
  double most = 0.0;
  for (const Region<D>& region : body.regions) {
    const auto look = [&](Index s) {
      const Tangent<D> A = tangent<D>(region.law, stretch<D>(state, s)) -
                           tangent<D>(region.law, stretch<D>(before, s));
      for (int i = 0; i < D * D; ++i)
        most = std::max(most, A(i, i) + A.row(i).cwiseAbs().sum() - std::abs(A(i, i)));
    };
    if (region.points.empty())
      for (Index s = 0; s < body.points.size(); ++s) look(s);
    else
      for (const int s : region.points) look(s);
  }
  return most;
}

/// γ max λ_max(A(H) − A(H₀)), from what it does to the step.
template <int D>
double added(const AdaptiveStep<D>& follower, const State<D>& state) {
  const double share = follower.bound(state) / follower.critical().dt;
  const double omega = 2.0 / follower.critical().dt;
  return omega * omega * (1.0 / (share * share) - 1.0);
}

TYPED_TEST(Follower, AddsTheTangentsOfEveryLaw) {
  constexpr int D = TypeParam::value;
  const std::vector<AnyLaw<D>> laws = nonlinear_laws<D>();
  for (std::size_t k = 0; k < laws.size(); ++k) {
    Discretisation<D> body = cells_of<D>(7);
    body.regions = {{laws[k], test::density, {}}, {laws[(k + 1) % laws.size()], test::density, {}}};
    for (int s = 0; s < body.points.size(); ++s)
      body.regions[s % 3 == 0 ? 0 : 1].points.push_back(s);
    const State<D> before = stretched<D>(body, 1.05, 0.02);
    const AdaptiveStep<D> follower(body, before, 0.9);
    double gamma = 0.0;

    for (const double factor : {0.5, 0.8, 0.97, 1.06, 1.2})
      for (const double disorder : {0.0, 0.06}) {
        const State<D> state = stretched<D>(body, factor, disorder);
        const double expected = stiffening<D>(body, state, before);
        const double found = added<D>(follower, state);

        if (gamma == 0.0) gamma = found / expected;
        EXPECT_NEAR(found, gamma * expected, 1e-7 * gamma * expected + 1e-7 * test::young)
            << k << ' ' << factor << ' ' << disorder;
      }
    EXPECT_GT(gamma, 0.0);
  }
}

TYPED_TEST(Follower, ReadsStrainsByASweepAsThoseOfEvaluatedStates) {
  constexpr int D = TypeParam::value;
  for (const bool modes : {false, true}) {
    Discretisation<D> body = cells_of<D>(45, LawName::neo_hookean);
    if constexpr (D == 2)
      if (modes)
        body.hourglass = {hourglass_weights(body.particles, body.gradient),
                          ScalarField::Constant(body.points.size(), 0.1 * test::young)};
    State<D> evaluated = stretched<D>(body, 1.0, 0.0);
    State<D> moved = stretched<D>(body, 1.0, 0.0);
    AdaptiveStep<D> by_strains(body, evaluated, 0.95);
    AdaptiveStep<D> by_sweep(body, moved, 0.95);
    const Sweep<D> sweep(body);
    by_sweep.use_operators_of(sweep);

    for (int n = 0; n < 60; ++n) {
      const double factor = 1.0 - 0.01 * n;
      evaluated.u.col(0) = (factor - 1.0) * body.particles.X.col(0);
      moved.u = evaluated.u;
      evaluate<D>(body, evaluated);
      evaluated.step = moved.step = n + 1;
      evaluated.last_dt = moved.last_dt = 1e-5;

      EXPECT_EQ(by_strains.update(evaluated), by_sweep.update(moved));
      EXPECT_NEAR(by_sweep.step(), by_strains.step(), 1e-9 * by_strains.step()) << n;
      if (n % 20 == 19) {
        EXPECT_NEAR(by_sweep.bound(moved), by_strains.bound(evaluated), 1e-9 * by_strains.step());
      }
    }
    EXPECT_EQ(by_sweep.bounds(), by_strains.bounds());
    EXPECT_EQ(by_sweep.estimates(), by_strains.estimates());
    EXPECT_GT(by_sweep.bounds(), 5);
  }
}

/// The allowance between bounds is a fiftieth at a safety of 0.9, and half of it makes one.
TYPED_TEST(Follower, TakesABoundWhereOnePointHasDeformed) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(7, LawName::neo_hookean);
  for (const Index point : {Index{0}, body.points.size() / 2, body.points.size() - 1})
    for (const auto& [deformation, bounds] : {std::pair{0.0099, 0L}, std::pair{0.0101, 1L}}) {
      State<D> state = stretched<D>(body, 1.1, 0.03);
      AdaptiveStep<D> follower(body, state, 0.9);
      const Tensor<D> H = stretch<D>(state, point);
      const Tensor<D> F = deformation_gradient<D>(H);
      Tensor<D> change = Tensor<D>::Constant(0.3);
      change(0, 0) = -1.0;
      // ‖ΔU‖ ‖U⁻¹‖ with U after the change: a few steps of a fixed point.
      double size = 0.0;
      for (int n = 0; n < 30; ++n) {
        const Tensor<D> after = F + size * change;
        size = deformation / (change.norm() * after.inverse().norm());
      }
      Eigen::Map<Tensor<D>>(state.H.data() + point * D * D) = H + size * change;
      ++state.step;
      state.last_dt = 1e-5;

      (void)follower.update(state);

      EXPECT_EQ(follower.bounds(), bounds) << point << ' ' << deformation;
    }
}

TYPED_TEST(Follower, RestsOnForcesLinearisedAtTheState) {
  constexpr int D = TypeParam::value;
  const auto body = cells_of<D>(5, LawName::neo_hookean);
  State<D> state = stretched<D>(body, 0.7, 0.05);
  LinearisedForces<D> forces(body, state);
  const State<D> direction = stretched<D>(body, 1.3, 0.1);
  VectorField<D> product = VectorField<D>::Zero(body.nodes(), D);

  forces.product(direction.u, product);

  const double size = 1e-6;
  const auto force_at = [&](double share) {
    State<D> moved = make_state<D>(body, state.u + share * direction.u, state.v);
    evaluate<D>(body, moved);
    return moved.f;
  };
  const VectorField<D> difference = (force_at(size) - force_at(-size)) / (2.0 * size);
  EXPECT_LT((product - difference).norm(), 1e-6 * difference.norm());

  const Sweep<D> sweep(body);
  VectorField<D> by_sweep = VectorField<D>::Zero(body.nodes(), D);
  LinearisedForces<D>(body, state, &sweep).product(direction.u, by_sweep);
  EXPECT_LT((by_sweep - product).norm(), 1e-13 * product.norm());
}

}  // namespace
}  // namespace tlsph

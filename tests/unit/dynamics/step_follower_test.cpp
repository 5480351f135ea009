/// The step of a body that deforms: its bound is one, and it is followed through a compression.
#include "tlsph/dynamics/step_follower.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bodies.hpp"

namespace tlsph {
namespace {

using test::cells_of;

template <int D>
State<D> stretched(const Discretisation<D>& disc, double factor, double disorder) {
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> random(-disorder * disc.spacing, disorder * disc.spacing);
  VectorField<D> u = VectorField<D>::Zero(disc.nodes(), D);
  u.col(0) = (factor - 1.0) * disc.particles.X.col(0);
  for (Index k = 0; k < u.size(); ++k) u.data()[k] += random(bits);
  State<D> state = make_state<D>(disc, u, VectorField<D>::Zero(disc.nodes(), D));
  evaluate<D>(disc, state);
  return state;
}

template <class Dimension>
class Follower : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>>;
TYPED_TEST_SUITE(Follower, Dimensions);

TYPED_TEST(Follower, BoundsTheCriticalStepAtAnyState) {
  constexpr int D = TypeParam::value;
  const auto disc = cells_of<D>(8, LawName::neo_hookean);
  const StepFollower<D> follower(disc, stretched<D>(disc, 1.0, 0.0), 0.9);

  for (const double factor : {0.2, 0.4, 0.7, 0.95, 1.0, 1.1, 1.5, 3.0})
    for (const double disorder : {0.0, 0.04}) {
      const State<D> state = stretched<D>(disc, factor, disorder);
      const double limit = critical_step<D>(disc, state).dt;
      const double bound = follower.bound(state);

      EXPECT_LE(bound, 1.002 * limit) << factor << ' ' << disorder;
      if (factor < 1.0) {
        EXPECT_GE(bound, 0.5 * limit) << factor << ' ' << disorder;
      }
    }
}

/// Pressed at a hundredth of the speed of sound a step; returns the largest Δt over the limit.
template <int D>
double worst_share(const Discretisation<D>& disc, StepFollower<D>& follower, State<D>& state,
                   double speed, double until) {
  double worst = 0.0;
  double factor = 1.0;
  double dt = follower.step();
  const double length = disc.particles.X.col(0).maxCoeff();
  while (factor > until) {
    if (follower.follow(state)) dt = follower.step();
    worst = std::max(worst, dt / critical_step<D>(disc, state).dt);
    factor -= speed * disc.wave_speed() * dt / length;
    state.u.col(0) = (factor - 1.0) * disc.particles.X.col(0);
    ++state.step;
    state.last_dt = dt;
    evaluate<D>(disc, state);
  }
  return worst;
}

TYPED_TEST(Follower, StaysBelowTheLimitThroughACompressionToAFifth) {
  constexpr int D = TypeParam::value;
  const auto disc = cells_of<D>(6, LawName::neo_hookean);
  for (const double speed : {0.01, 0.2}) {
    State<D> state = stretched<D>(disc, 1.0, 0.0);
    StepFollower<D> follower(disc, state, 0.95);

    const double worst = worst_share<D>(disc, follower, state, speed, 0.2);

    EXPECT_LE(worst, 0.97) << speed;
    EXPECT_GE(worst, 0.9) << speed;
    EXPECT_LE(follower.estimates(), 10) << speed;
  }
}

TYPED_TEST(Follower, LooksRarelyAtABodyAtRest) {
  constexpr int D = TypeParam::value;
  const auto disc = cells_of<D>(4, LawName::neo_hookean);
  State<D> state = stretched<D>(disc, 1.0, 0.0);
  StepFollower<D> follower(disc, state, 0.9);

  for (state.step = 1; state.step <= 1600; ++state.step) EXPECT_FALSE(follower.follow(state));

  EXPECT_LE(follower.looks(), 110);
  EXPECT_EQ(follower.bounds(), 0);
  EXPECT_EQ(follower.estimates(), 1);
}

TYPED_TEST(Follower, GoesOnFromItsNumbersAsIfItHadNotStopped) {
  constexpr int D = TypeParam::value;
  const auto disc = cells_of<D>(5, LawName::neo_hookean);
  State<D> state = stretched<D>(disc, 1.0, 0.0);
  StepFollower<D> follower(disc, state, 0.95);
  StepFollower<D> resumed(disc, state, 0.95);
  (void)worst_share<D>(disc, follower, state, 0.05, 0.6);
  const auto copy = [](const TensorField<D>& field) {
    return std::vector<double>(field.data(), field.data() + field.size());
  };

  resumed.restore(follower.numbers(), copy(follower.estimated_at()), copy(follower.checked_at()));

  for (int n = 0; n < 200; ++n) {
    state.u.col(0) *= 1.004;
    ++state.step;
    evaluate<D>(disc, state);
    EXPECT_EQ(follower.follow(state), resumed.follow(state));
    EXPECT_EQ(follower.step(), resumed.step());
  }
  EXPECT_THAT(resumed.numbers(),
              testing::Pointwise(testing::NanSensitiveDoubleEq(), follower.numbers()));
}

TYPED_TEST(Follower, RestsOnForcesLinearisedAtTheState) {
  constexpr int D = TypeParam::value;
  const auto disc = cells_of<D>(5, LawName::neo_hookean);
  State<D> state = stretched<D>(disc, 0.7, 0.05);
  LinearisedForces<D> forces(disc, state);
  const State<D> direction = stretched<D>(disc, 1.3, 0.1);
  VectorField<D> product = VectorField<D>::Zero(disc.nodes(), D);

  forces.product(direction.u, product);

  const double size = 1e-6;
  const auto force_at = [&](double share) {
    State<D> moved = make_state<D>(disc, state.u + share * direction.u, state.v);
    evaluate<D>(disc, moved);
    return moved.f;
  };
  const VectorField<D> difference = (force_at(size) - force_at(-size)) / (2.0 * size);
  EXPECT_LT((product - difference).norm(), 1e-6 * difference.norm());
}

}  // namespace
}  // namespace tlsph

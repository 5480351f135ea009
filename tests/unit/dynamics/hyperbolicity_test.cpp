/// Which material point of a body carries no waves any more.

#include "tlsph/dynamics/hyperbolicity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

template <int D>
State<D> stretched(const Discretisation<D>& body, const VectorField<D>& u) {
  State<D> state = make_state<D>(body, u, VectorField<D>::Zero(body.nodes(), D));
  evaluate<D>(body, state);
  return state;
}

/// A bar of three cells with these stretches.
State<1> bar_with(const Discretisation<1>& body, const std::array<double, 3>& stretches) {
  VectorField<1> u = VectorField<1>::Zero(4, 1);
  for (Index cell = 0; cell < 3; ++cell)
    u(cell + 1, 0) = u(cell, 0) + (stretches[static_cast<std::size_t>(cell)] - 1.0) * body.spacing;
  return stretched<1>(body, u);
}

Discretisation<1> rubber_bar() {
  auto body = test::cells_of<1>(3);
  body.regions = {
      {make_law<1>(LawName::neo_hookean, Assumption::strain, test::young, 0.49), 1000.0, {}}};
  return body;
}

/// dP/dF = μ(1 + 1/F²) + λ(1 − ln F)/F² is negative between 3.63 and 6.40 and least at 4.4.
TEST(MostUnstablePoint, IsTheOneFurthestBeyondTheLimit) {
  const auto body = rubber_bar();
  EXPECT_FALSE(most_unstable_point<1>(body, bar_with(body, {1.0, 3.62, 6.41})));

  const auto worst = most_unstable_point<1>(body, bar_with(body, {3.65, 4.4, 2.0}));

  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->point, 1);
  EXPECT_NEAR(worst->stretches[0], 4.4, 1e-12);
  const Lame constants = lame(test::young, 0.49);
  const double F2 = 4.4 * 4.4;
  const double expected = constants.mu * (1 + 1 / F2) + constants.lambda * (1 - std::log(4.4)) / F2;
  EXPECT_NEAR(worst->acoustic_eigenvalue, expected, 1e-9 * constants.mu);
}

TEST(MostUnstablePoint, IsSoughtInEveryRegion) {
  auto body = rubber_bar();
  const auto soft = make_law<1>(LawName::neo_hookean, Assumption::strain, test::young, 0.3);
  body.regions = {{soft, 1000.0, {0, 1}}, {body.regions[0].law, 1000.0, {2}}};

  const auto worst = most_unstable_point<1>(body, bar_with(body, {4.4, 4.4, 4.0}));

  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->point, 2);
}

/// Largest stretch first, whatever the axes: λ₁ = 3, λ₂ = 2 in a sheet at ν = 0.49.
TEST(MostUnstablePoint, NamesThePrincipalStretches) {
  auto body = test::cells_of<2>(2);
  body.regions = {
      {make_law<2>(LawName::neo_hookean, Assumption::strain, test::young, 0.49), 1000.0, {}}};
  VectorField<2> u(body.nodes(), 2);
  u.col(0) = body.particles.X.col(0);
  u.col(1) = 2.0 * body.particles.X.col(1);

  const auto worst = most_unstable_point<2>(body, stretched<2>(body, u));

  ASSERT_TRUE(worst);
  EXPECT_NEAR(worst->stretches[0], 3.0, 1e-12);
  EXPECT_NEAR(worst->stretches[1], 2.0, 1e-12);
  EXPECT_LT(worst->acoustic_eigenvalue, 0.0);
}

TEST(MostUnstablePoint, IsNoneOfALinearBody) {
  const auto body = test::cells_of<1>(3);
  EXPECT_FALSE(most_unstable_point<1>(body, bar_with(body, {0.1, 4.4, 50.0})));
}

}  // namespace
}  // namespace tlsph

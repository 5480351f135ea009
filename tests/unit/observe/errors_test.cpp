/// Relative errors of states whose distance from the exact solution is known.

#include "tlsph/observe/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

/// u = a X, v = c X, P of u, on a bar of four cells.
ExactSolution<1> linear_field(const Discretisation<1>& disc, double a, double c) {
  const double modulus = tangent<1>(disc.regions[0].law, Tensor<1>::Zero())(0, 0);
  return {[a](const Vector<1>& X, double) { return Vector<1>(a * X); },
          [c](const Vector<1>& X, double) { return Vector<1>(c * X); },
          [a, modulus](const Vector<1>&, double) { return Tensor<1>(a * modulus); }};
}

/// The bar at u = 1e-3 X, v = 2 X, at rest but for that.
State<1> stretched(const Discretisation<1>& disc) {
  State<1> state = make_state<1>(disc, 1e-3 * disc.particles.X, 2.0 * disc.particles.X);
  evaluate<1>(disc, state);
  state.f.setZero();
  return state;
}

TEST(Errors, VanishOnTheExactSolution) {
  const auto disc = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(disc, 1e-3, 2.0), {disc, stretched(disc), 1e-6});

  EXPECT_LE(errors.displacement, 1e-14);
  EXPECT_LE(errors.velocity, 1e-14);
  EXPECT_LE(errors.stress, 1e-14);
}

TEST(Errors, AreSharesOfTheExactSolution) {
  const auto disc = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(disc, 0.8e-3, 2.5), {disc, stretched(disc), 1e-6});

  EXPECT_NEAR(errors.displacement, 0.25, 1e-12);
  EXPECT_NEAR(errors.velocity, 0.2, 1e-12);
  EXPECT_NEAR(errors.stress, 0.25, 1e-12);
}

/// Against rest they are norms, √(Σ V|a|²): nodes weigh with their volumes, half ones at the ends.
TEST(Errors, AreNormsWhereTheExactSolutionVanishes) {
  const auto disc = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(disc, 0.0, 0.0), {disc, stretched(disc), 1e-6});

  const double d = disc.spacing;
  const double squares = d * d * d * (1.0 + 4.0 + 9.0 + 0.5 * 16.0);
  EXPECT_NEAR(errors.displacement, 1e-3 * std::sqrt(squares), 1e-15);
  EXPECT_NEAR(errors.velocity, 2.0 * std::sqrt(squares), 1e-12);
}

}  // namespace
}  // namespace tlsph

/// Relative errors of states whose distance from the exact solution is known.

#include "tlsph/observe/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

/// u = a X, v = c X, P of u, on a bar of four cells.
ExactSolution<1> linear_field(const Discretisation<1>& body, double a, double c) {
  const double modulus = tangent<1>(body.regions[0].law, Tensor<1>::Zero())(0, 0);
  return {[a](const Vector<1>& X, double) { return Vector<1>(a * X); },
          [c](const Vector<1>& X, double) { return Vector<1>(c * X); },
          [a, modulus](const Vector<1>&, double) { return Tensor<1>(a * modulus); }};
}

/// The bar at u = 1e-3 X, v = 2 X, at rest but for that.
State<1> stretched(const Discretisation<1>& body) {
  State<1> state = make_state<1>(body, 1e-3 * body.particles.X, 2.0 * body.particles.X);
  evaluate<1>(body, state);
  state.f.setZero();
  return state;
}

TEST(Errors, VanishOnTheExactSolution) {
  const auto body = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(body, 1e-3, 2.0), {body, stretched(body), 1e-6});

  EXPECT_LE(errors.displacement, 1e-14);
  EXPECT_LE(errors.velocity, 1e-14);
  EXPECT_LE(errors.stress, 1e-14);
}

TEST(Errors, AreSharesOfTheExactSolution) {
  const auto body = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(body, 0.8e-3, 2.5), {body, stretched(body), 1e-6});

  EXPECT_NEAR(errors.displacement, 0.25, 1e-12);
  EXPECT_NEAR(errors.velocity, 0.2, 1e-12);
  EXPECT_NEAR(errors.stress, 0.25, 1e-12);
}

/// Against rest they are norms, √(Σ V|a|²): nodes weigh with their volumes, half ones at the ends.
TEST(Errors, AreNormsWhereTheExactSolutionVanishes) {
  const auto body = test::cells_of<1>(4);

  const RelativeErrors errors =
      errors_against<1>(linear_field(body, 0.0, 0.0), {body, stretched(body), 1e-6});

  const double d = body.spacing;
  const double squares = d * d * d * (1.0 + 4.0 + 9.0 + 0.5 * 16.0);
  EXPECT_NEAR(errors.displacement, 1e-3 * std::sqrt(squares), 1e-15);
  EXPECT_NEAR(errors.velocity, 2.0 * std::sqrt(squares), 1e-12);
}

}  // namespace
}  // namespace tlsph

#include "tlsph/particles/interpolation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

double interpolate(const VectorField<2>& X, const Vector<2>& x,
                   const std::function<double(double, double)>& f) {
  const InterpolationRow row = linear_interpolation<2>(X, x, 1.0);
  double value = 0.0;
  for (std::size_t k = 0; k < row.node.size(); ++k)
    value += row.weight[k] * f(X(row.node[k], 0), X(row.node[k], 1));
  return value;
}

TEST(LinearInterpolation, IsExactForLinearFields) {
  VectorField<2> X(6, 2);
  X << 0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1;

  EXPECT_NEAR(interpolate(X, {1.3, 0.4}, [](double x, double y) { return 2 + 3 * x - y; }), 5.5,
              1e-13);
}

TEST(LinearInterpolation, AlongARowOfNodesIsLinearAlongItAndConstantAcross) {
  // Stress points of a body one cell thick, asked for at its end and at its upper side.
  VectorField<2> X(4, 2);
  X << 0.5, 0.5, 1.5, 0.5, 2.5, 0.5, 3.5, 0.5;
  const auto field = [](double x, double) { return 1 + 2 * x; };

  EXPECT_NEAR(interpolate(X, {4.0, 0.5}, field), 9.0, 1e-13);
  EXPECT_NEAR(interpolate(X, {4.0, 1.0}, field), 9.0, 1e-13);
  EXPECT_NEAR(interpolate(X, {2.2, 0.0}, field), 5.4, 1e-13);
}

TEST(LinearInterpolation, OfOneNodeIsRefused) {
  VectorField<2> X(1, 2);
  X << 0.5, 0.5;

  EXPECT_THROW((void)linear_interpolation<2>(X, {1.0, 1.0}, 1.0), InputError);
}

}  // namespace
}  // namespace tlsph

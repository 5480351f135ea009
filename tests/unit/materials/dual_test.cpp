#include "tlsph/materials/dual.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tlsph {
namespace {

/// All operations of two numbers, and of a number and a double on either side.
template <class R>
R formula(const R& x, const R& y) {
  const R quotient = (x * y + 2.0) / (3.0 - x / 7.0);
  return 1.5 / (y + quotient) - quotient * 0.25 + (x - y) / (0.5 + x * x) - (-y) * 2.0;
}

TEST(Dual, DerivativesAreTheLimitsOfDifferences) {
  for (const double x : {-1.3, 0.2, 4.0})
    for (const double y : {0.7, 2.9}) {
      const Dual<double, 2> result =
          formula(Dual<double, 2>{x, {1.0, 0.0}}, Dual<double, 2>{y, {0.0, 1.0}});
      const double step = 1e-3;
      // of fourth order
      const auto slope = [&](double dx, double dy) {
        const auto change = [&](double h) {
          return formula(x + h * dx, y + h * dy) - formula(x - h * dx, y - h * dy);
        };
        return (8 * change(step) - change(2 * step)) / (12 * step);
      };

      EXPECT_NEAR(result.value, formula(x, y), 1e-14);
      EXPECT_NEAR(result.change[0], slope(1.0, 0.0), 1e-9);
      EXPECT_NEAR(result.change[1], slope(0.0, 1.0), 1e-9);
    }
}

TEST(Dual, QuotientByHand) {
  // (3/x)' = −3/x², (x/(x+1))' = 1/(x+1)² at x = 2
  const Dual<double> x{2.0, {1.0}};
  EXPECT_DOUBLE_EQ((3.0 / x).change[0], -0.75);
  EXPECT_DOUBLE_EQ((x / (x + 1.0)).value, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ((x / (x + 1.0)).change[0], 1.0 / 9.0);
  EXPECT_DOUBLE_EQ((x / 4.0).change[0], 0.25);
}

}  // namespace
}  // namespace tlsph

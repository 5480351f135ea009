#include "tlsph/kernels/families.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace tlsph {
namespace {

/// Composite five-point Gauss–Legendre rule on [0, 1]; the panels meet at 1/2, where the spline is
/// only twice differentiable.
template <class Integrand>
double quadrature(Integrand f, int panels = 512) {
  const std::array<double, 3> x = {0.0, std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3,
                                   std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3};
  const std::array<double, 3> w = {128.0 / 225, (322 + 13 * std::sqrt(70.0)) / 900,
                                   (322 - 13 * std::sqrt(70.0)) / 900};
  const double half = 0.5 / panels;
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double centre = (2 * i + 1) * half;
    sum += w[0] * f(centre);
    for (std::size_t k = 1; k < 3; ++k)
      sum += w[k] * (f(centre - half * x[k]) + f(centre + half * x[k]));
  }
  return sum * half;
}

/// ∫ W dV over the ball of radius h in D dimensions.
template <int D, class Family>
double kernel_integral(double h) {
  const double sphere = D == 1 ? 2.0 : D == 2 ? 2 * std::numbers::pi : 4 * std::numbers::pi;
  return sphere * quadrature([h](double q) {
           return h * std::pow(h * q, D - 1) * kernel_value<D>(Family{}, h * q, h);
         });
}

template <class Family>
class Kernel : public testing::Test {};

using Families = testing::Types<Lucy, CubicSpline, Gaussian, Mollifier, ModifiedMollifier,
                                Quadratic, WendlandC2>;
TYPED_TEST_SUITE(Kernel, Families);

TYPED_TEST(Kernel, IntegratesToOneInEveryDimension) {
  for (const double h : {1.0, 0.37, 2.5e-3}) {
    EXPECT_NEAR((kernel_integral<1, TypeParam>(h)), 1.0, 1e-12) << "1D, h = " << h;
    EXPECT_NEAR((kernel_integral<2, TypeParam>(h)), 1.0, 1e-12) << "2D, h = " << h;
    EXPECT_NEAR((kernel_integral<3, TypeParam>(h)), 1.0, 1e-12) << "3D, h = " << h;
  }
}

/// Fourth-order central difference of f at x.
template <class F>
double difference(F f, double x, double step) {
  return (8 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step))) / (12 * step);
}

TYPED_TEST(Kernel, DerivativesMatchFiniteDifferences) {
  const double h = 0.7;
  const TypeParam family;
  const double scale = kernel_value<2>(family, 0.0, h) / h;
  for (int i = 1; i < 40; ++i) {
    if (i == 20) continue;  // the knot of the cubic spline
    const double r = h * i / 40;
    const auto value = [&](double x) { return kernel_value<2>(family, x, h); };
    const auto first = [&](double x) { return kernel_first<2>(family, x, h); };
    EXPECT_NEAR(kernel_first<2>(family, r, h), difference(value, r, 2e-4 * h), 1e-7 * scale)
        << "q = " << r / h;
    EXPECT_NEAR(kernel_second<2>(family, r, h), difference(first, r, 2e-4 * h), 1e-6 * scale / h)
        << "q = " << r / h;
  }
}

TYPED_TEST(Kernel, VanishesFromTheSupportOn) {
  const double h = 0.25;
  const TypeParam family;
  for (const double r : {h, std::nextafter(h, 1.0), 1.7 * h}) {
    EXPECT_EQ(kernel_value<1>(family, r, h), 0.0);
    EXPECT_EQ(kernel_first<2>(family, r, h), 0.0);
    EXPECT_EQ(kernel_second<3>(family, r, h), 0.0);
  }
}

TYPED_TEST(Kernel, IsPositiveInsideAndDecreases) {
  for (int i = 1; i < 90; ++i) {
    const double q = i / 100.0;
    EXPECT_GT(TypeParam::shape(q), 0.0) << "q = " << q;
    EXPECT_LT(TypeParam::first(q), 0.0) << "q = " << q;
  }
}

TYPED_TEST(Kernel, IsFiniteUpToBothEnds) {
  const double edge = std::nextafter(1.0, 0.0);
  for (const double q : {0.0, std::numeric_limits<double>::denorm_min(), 0.999, 1 - 1e-9, edge}) {
    EXPECT_TRUE(std::isfinite(TypeParam::shape(q))) << "q = " << q;
    EXPECT_TRUE(std::isfinite(TypeParam::first(q))) << "q = " << q;
    EXPECT_TRUE(std::isfinite(TypeParam::second(q))) << "q = " << q;
  }
  EXPECT_LT(TypeParam::shape(edge), 1.3e-4 * TypeParam::shape(0.0));  // 1.2e-4 for the Gaussian
}

TYPED_TEST(Kernel, IsFoundByItsName) {
  const auto kernel = kernel_by_name(TypeParam::name);
  ASSERT_TRUE(kernel.has_value());
  EXPECT_TRUE(std::holds_alternative<TypeParam>(*kernel));
}

TEST(KernelNames, AreThoseOfScenes) {
  const std::vector<std::string_view> expected = {"lucy",       "cubic-spline",       "gaussian",
                                                  "mollifier",  "modified-mollifier", "quadratic",
                                                  "wendland-c2"};
  EXPECT_EQ(kernel_names(), expected);
  EXPECT_FALSE(kernel_by_name("cubic").has_value());
  EXPECT_FALSE(kernel_by_name("").has_value());
}

TEST(KernelByHand, KnownValues) {
  // M₄ with smoothing length h/2: W(0) = 2/(3 (h/2)) in 1D, 10/(7π (h/2)²) in 2D.
  EXPECT_DOUBLE_EQ(kernel_value<1>(CubicSpline{}, 0.0, 2.0), 2.0 / 3);
  EXPECT_DOUBLE_EQ(kernel_value<2>(CubicSpline{}, 0.0, 2.0), 10 / (7 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(kernel_value<1>(CubicSpline{}, 1.0, 2.0), 1.0 / 6);
  EXPECT_DOUBLE_EQ(Mollifier::shape(0.0), std::exp(-1.0));
  EXPECT_DOUBLE_EQ(ModifiedMollifier::shape(0.5), std::exp(-4.0 / 3) * std::pow(0.75, 8));
  EXPECT_DOUBLE_EQ(Quadratic::shape(0.5), 3.0 / 16 - 3.0 / 4 + 3.0 / 4);
  EXPECT_DOUBLE_EQ(Lucy::second(0.0), -12.0);
}

}  // namespace
}  // namespace tlsph

#include "tlsph/linear/krylov.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "matrices.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using test::laplacian;
using test::random_matrix;

template <typename Matrix>
LinearMap as_map(const Matrix& A) {
  return [A](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = A * x; };
}

std::vector<std::complex<double>> dense_eigenvalues(const Eigen::MatrixXd& A) {
  const Eigen::VectorXcd values = A.eigenvalues();
  return {values.begin(), values.end()};
}

double distance_to_nearest(const std::complex<double>& z,
                           const std::vector<std::complex<double>>& values) {
  double nearest = INFINITY;
  for (const auto& value : values) nearest = std::min(nearest, std::abs(z - value));
  return nearest;
}

class Laplacian : public testing::TestWithParam<Index> {};

TEST_P(Laplacian, LargestEigenvalueLiesBetweenValueAndBound) {
  const Index n = GetParam();
  const double exact = 4 * std::pow(std::sin(0.5 * std::numbers::pi * static_cast<double>(n) /
                                             static_cast<double>(n + 1)),
                                    2);

  const LanczosResult found = largest_eigenvalue(as_map(laplacian(n)), n, {.max_steps = 200});

  EXPECT_TRUE(found.converged);
  EXPECT_LE(found.value, exact * (1 + 1e-14));
  EXPECT_GE(found.upper_bound, exact * (1 - 1e-14));
  EXPECT_LE(found.residual, 1e-4 * found.value);
}

INSTANTIATE_TEST_SUITE_P(, Laplacian, testing::Values(1, 2, 3, 10, 40, 100, 200));

TEST(LargestEigenvalue, AgreesWithADenseSolverForManyRandomMatrices) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Eigen::MatrixXd B = random_matrix(30, 30, seed);
    const Eigen::MatrixXd A = B * B.transpose();
    const double exact = A.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();

    const LanczosResult found =
        largest_eigenvalue(as_map(A), 30, {.tolerance = 1e-6, .seed = seed});

    EXPECT_TRUE(found.converged) << seed;
    EXPECT_NEAR(found.value, exact, 1e-6 * exact) << seed;
    EXPECT_GE(found.upper_bound, exact * (1 - 1e-13)) << seed;
  }
}

TEST(LargestEigenvalue, ResidualIsThatOfTheRitzVectorWhenItStopsEarly) {
  const LanczosResult found = largest_eigenvalue(as_map(laplacian(500)), 500, {.max_steps = 5});

  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.steps, 5);
  EXPECT_GT(found.residual, 1e-4 * found.value);
  EXPECT_DOUBLE_EQ(found.upper_bound, found.value + found.residual);
}

TEST(LargestEigenvalue, IsTheRightmostNotTheLargestInModulus) {
  const Eigen::MatrixXd A = Eigen::Vector4d(-9, -4, 1, 3).asDiagonal();

  EXPECT_NEAR(largest_eigenvalue(as_map(A), 4).value, 3, 1e-12);
}

TEST(LargestEigenvalue, OfAMultipleOfTheIdentityTakesOneStep) {
  const LanczosResult found =
      largest_eigenvalue([](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = 7 * x; }, 1000);

  EXPECT_EQ(found.steps, 1);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.value, 7, 1e-13);
}

TEST(LargestEigenvalue, OfTheZeroOperatorIsZero) {
  const LanczosResult found =
      largest_eigenvalue([](const Eigen::VectorXd&, Eigen::VectorXd& y) { y.setZero(); }, 12);

  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.upper_bound, 0);
}

TEST(LargestEigenvalue, RepeatsItsBitsAndVariesWithTheSeed) {
  const auto run = [](std::uint64_t seed) {
    return largest_eigenvalue(as_map(laplacian(200)), 200, {.seed = seed}).value;
  };

  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(LargestEigenvalue, RefusesWhatIsNotFinite) {
  const LinearMap broken = [](const Eigen::VectorXd&, Eigen::VectorXd& y) { y.setConstant(NAN); };

  EXPECT_THROW((void)largest_eigenvalue(broken, 5), NumericalError);
  EXPECT_THROW((void)arnoldi_eigenvalues(broken, 5, 3), NumericalError);
}

TEST(Arnoldi, FindsAllEigenvaluesInAsManyStepsAsRows) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Eigen::MatrixXd A = random_matrix(12, 12, seed);
    const auto exact = dense_eigenvalues(A);

    const auto found = arnoldi_eigenvalues(as_map(A), 12, 12);

    ASSERT_EQ(found.size(), 12U);
    for (const auto& z : exact) EXPECT_LT(distance_to_nearest(z, found), 1e-10) << seed;
  }
}

TEST(Arnoldi, FindsTheConjugatePairOfARotationFirst) {
  Eigen::MatrixXd A = 0.1 * random_matrix(50, 50, 3) / std::sqrt(50.0);
  A.topLeftCorner(2, 2) = Eigen::Matrix2d{{0, -3}, {3, 0}};
  A.topRightCorner(2, 48).setZero();

  const auto found = arnoldi_eigenvalues(as_map(A), 50, 15);

  ASSERT_EQ(found.size(), 15U);
  EXPECT_NEAR(std::abs(found[0].imag()), 3, 1e-10);
  EXPECT_NEAR(found[0].real(), 0, 1e-10);
  EXPECT_EQ(found[1], std::conj(found[0]));
  EXPECT_TRUE(
      std::ranges::is_sorted(found, std::ranges::greater{}, [](auto z) { return std::abs(z); }));
}

TEST(Arnoldi, StopsWhenTheKrylovSpaceCloses) {
  // Two distinct eigenvalues: the space of any start vector has dimension two.
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(20, 2.0);
  diagonal.tail(10).setConstant(-5.0);
  const Eigen::MatrixXd A = diagonal.asDiagonal();

  const auto found = arnoldi_eigenvalues(as_map(A), 20, 20);

  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].real(), -5, 1e-13);
  EXPECT_NEAR(found[1].real(), 2, 1e-13);
}

TEST(Krylov, WantsAtLeastOneEntryAndOneStep) {
  const LinearMap identity = [](const Eigen::VectorXd& x, Eigen::VectorXd& y) { y = x; };

  EXPECT_THROW((void)largest_eigenvalue(identity, 0), std::invalid_argument);
  EXPECT_THROW((void)largest_eigenvalue(identity, 3, {.max_steps = 0}), std::invalid_argument);
  EXPECT_THROW((void)arnoldi_eigenvalues(identity, 3, 0), std::invalid_argument);
}

}  // namespace
}  // namespace tlsph

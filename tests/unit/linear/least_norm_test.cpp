#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>

#include "matrices.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph {
namespace {

using test::random_matrix;
using test::sparse;

TEST(LeastNorm, IsTheShortestSolution) {
  for (const auto& [rows, cols] : {std::pair{1, 1}, {6, 6}, {5, 12}, {70, 90}}) {
    const Eigen::MatrixXd A = random_matrix(rows, cols, 1);
    const Eigen::VectorXd b = random_matrix(rows, 1, 2);

    const Eigen::VectorXd x = LeastNorm(sparse(A.transpose())).solve(b);

    const Eigen::VectorXd expected = A.completeOrthogonalDecomposition().solve(b);
    EXPECT_LT((x - expected).norm(), 1e-11 * expected.norm());
  }
}

TEST(LeastNorm, SharesTheLoadOfOneConditionEqually) {
  const Eigen::Matrix<double, 1, 1> b(2.0);
  const Eigen::Vector4d x = LeastNorm(sparse(Eigen::Vector4d(1, 1, 1, 1))).solve(b);
  EXPECT_TRUE(x.isApprox(Eigen::Vector4d::Constant(0.5), 1e-15));
}

/// A Aᵀ has the eigenvalues 6 and 7e-21, the second below the rounding of the first.
TEST(LeastNorm, MeetsConditionsThatNearlyDepend) {
  const Eigen::Matrix<double, 2, 3> A{{1, 1, 1}, {1, 1 + 1e-10, 1 - 1e-10}};
  const Eigen::Vector2d b = A * Eigen::Vector3d(3.0, -2.0, 1.0);

  const Eigen::Vector3d x = LeastNorm(sparse(A.transpose())).solve(b);

  EXPECT_LT((A * x - b).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(LeastNorm, RefusesWhatItCannotSolve) {
  const auto refuses = [](const Eigen::MatrixXd& transposed) {
    EXPECT_THROW(LeastNorm(sparse(transposed)), NumericalError);
  };
  refuses(Eigen::Matrix2d{{1, INFINITY}, {0, 1}});
  refuses(Eigen::RowVector2d(1, 1));
  refuses(Eigen::Matrix<double, 3, 2>{{1, 0}, {2, 0}, {2, 0}});
}

}  // namespace
}  // namespace tlsph

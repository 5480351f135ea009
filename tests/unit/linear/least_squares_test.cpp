#include <gtest/gtest.h>

#include "matrices.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph {
namespace {

using test::random_matrix;
using test::sparse;

struct Shape {
  Index rows;
  Index cols;
  Index rank;
};
class LeastSquaresOfShape : public testing::TestWithParam<Shape> {};

TEST_P(LeastSquaresOfShape, IsTheShortestOfTheBestSolutions) {
  const auto [rows, cols, rank] = GetParam();
  const Eigen::MatrixXd A = random_matrix(rows, rank, 1) * random_matrix(rank, cols, 2);
  const Eigen::MatrixXd b = random_matrix(rows, 3, 3);

  const LeastSquares factor(sparse(A));
  const Eigen::MatrixXd x = factor.solve(b);

  EXPECT_EQ(factor.rank(), rank);
  const Eigen::MatrixXd expected = A.completeOrthogonalDecomposition().solve(b);
  EXPECT_LT((x - expected).norm(), 1e-12 * expected.norm());
}

INSTANTIATE_TEST_SUITE_P(, LeastSquaresOfShape,
                         testing::Values(Shape{6, 6, 6}, Shape{12, 5, 5}, Shape{5, 12, 5},
                                         Shape{9, 9, 4}, Shape{14, 8, 3}, Shape{8, 14, 3},
                                         Shape{1, 1, 1}, Shape{90, 70, 65}));

TEST(LeastSquares, FitsALineThroughPointsByHand) {
  // (0, 1), (1, 2), (2, 4): slope 3/2, offset 5/6.
  const SparseMatrix A = sparse(Eigen::Matrix<double, 3, 2>{{1, 0}, {1, 1}, {1, 2}});

  const Eigen::Vector2d line = LeastSquares(A).solve(Eigen::Vector3d(1, 2, 4));

  EXPECT_TRUE(line.isApprox(Eigen::Vector2d(5.0 / 6.0, 1.5), 1e-14));
}

TEST(LeastSquares, SharesTheLoadOfOneEquationEqually) {
  const SparseMatrix A = sparse(Eigen::RowVector4d(1, 1, 1, 1));

  const Eigen::Vector4d x = LeastSquares(A).solve(Eigen::Matrix<double, 1, 1>(2));

  EXPECT_TRUE(x.isApprox(Eigen::Vector4d::Constant(0.5), 1e-15));
}

TEST(LeastSquares, LeavesAnEmptyColumnAtZero) {
  const SparseMatrix A = sparse(Eigen::Matrix<double, 3, 2>{{1, 0}, {2, 0}, {2, 0}});

  const Eigen::Vector2d x = LeastSquares(A).solve(Eigen::Vector3d(9, 0, 0));

  EXPECT_TRUE(x.isApprox(Eigen::Vector2d(1, 0), 1e-15));
}

TEST(LeastSquares, RefusesWhatIsNotFinite) {
  EXPECT_THROW(LeastSquares(sparse(Eigen::Matrix2d{{1, INFINITY}, {0, 1}})), NumericalError);
}

}  // namespace
}  // namespace tlsph

/// What a factorisation will cost, foretold.

#include "tlsph/linear/factorization.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tlsph {
namespace {

SparseMatrix dense(int n) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Constant(n, n, 0.5);
  A.diagonal().setConstant(n);
  return A.sparseView();
}

SparseMatrix diagonal(int n) {
  SparseMatrix A(n, n);
  A.setIdentity();
  return A;
}

TEST(FactorCost, OfADenseMatrixIsThatOfItsTriangle) {
  const FactorCost cost = factor_cost(dense(60));

  EXPECT_EQ(cost.rows, 60);
  EXPECT_EQ(cost.entries, 60 * 61 / 2);
  EXPECT_EQ(cost.flops, 60 * 61 * 121 / 6);  // Σ k²
  EXPECT_GE(cost.bytes, 8 * cost.entries);
}

TEST(FactorCost, OfADiagonalMatrixHasNoFill) {
  EXPECT_EQ(factor_cost(diagonal(1000)).entries, 1000);
}

TEST(FactorCost, DoesNotLookAtValues) {
  SparseMatrix A = dense(10);
  A.coeffs().setConstant(-1.0);

  EXPECT_EQ(factor_cost(A).entries, 55);
}

TEST(FactorisationSpeed, IsThatOfAMachine) {
  const double speed = factorisation_speed();

  EXPECT_GE(speed, 1e8);
  EXPECT_LE(speed, 1e12);
}

}  // namespace
}  // namespace tlsph

#include "tlsph/linear/factorization.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "matrices.hpp"

namespace tlsph {
namespace {

using test::laplacian;
using test::laplacian_2d;
using test::random_matrix;
using test::relative_residual;
using test::sparse;

Eigen::MatrixXd hilbert(Index n) {
  Eigen::MatrixXd H(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) H(i, j) = 1.0 / static_cast<double>(i + j + 1);
  }
  return H;
}

double exact_condition(const Eigen::MatrixXd& A) {
  const auto norm = [](const Eigen::MatrixXd& M) {
    return M.cwiseAbs().colwise().sum().maxCoeff();
  };
  return norm(A) * norm(A.inverse());
}

/// What holds for each way to solve a symmetric positive definite system.
template <typename Factor>
class SquareSolve : public testing::Test {};
using SquareFactors = testing::Types<Cholesky, Lu, SymmetricOrGeneral>;
TYPED_TEST_SUITE(SquareSolve, SquareFactors);

TYPED_TEST(SquareSolve, GivesTheSolutionWorkedOutByHand) {
  const SparseMatrix A = laplacian(3);

  const Eigen::VectorXd x = TypeParam(A).solve(Eigen::Vector3d(1, 0, 0));

  EXPECT_TRUE(x.isApprox(Eigen::Vector3d(0.75, 0.5, 0.25), 1e-15));
}

TYPED_TEST(SquareSolve, LeavesNoResidualOnGridsSmallAndLarge) {
  for (const Index n : {1, 2, 7, 100}) {
    const SparseMatrix A = laplacian_2d(n, 0.01);
    const Eigen::VectorXd b = random_matrix(A.rows(), 1, 5);

    const Eigen::VectorXd x = TypeParam(A).solve(b);

    EXPECT_LT(relative_residual(A, x, b), 1e-13) << n;
  }
}

TYPED_TEST(SquareSolve, TakesRowMajorFieldsAndExpressions) {
  const SparseMatrix A = laplacian(10);
  const VectorField<2> b = random_matrix(10, 2, 6);

  const TypeParam factor(A);
  const VectorField<2> x = factor.solve(b);
  const Eigen::VectorXd twice = factor.solve(2.0 * b.col(1));

  EXPECT_LT(relative_residual(A, x, b), 1e-14);
  EXPECT_TRUE(twice.isApprox(2.0 * x.col(1), 1e-14));
}

TYPED_TEST(SquareSolve, SolvesIntoGivenMemoryAsOften) {
  const SparseMatrix A = laplacian_2d(20, 0.0);
  const TypeParam factor(A);
  SolveWorkspace workspace = factor.workspace();
  Eigen::VectorXd x(A.rows());

  for (unsigned seed = 0; seed < 3; ++seed) {
    const Eigen::VectorXd b = random_matrix(A.rows(), 1, seed);
    factor.solve_into(b.data(), x.data(), workspace);
    EXPECT_EQ(x, Eigen::VectorXd(factor.solve(b)));
  }
}

TYPED_TEST(SquareSolve, SurvivesTheMatrixAndAMove) {
  std::optional<SparseMatrix> A = laplacian(5);
  TypeParam original(*A);
  A.reset();

  const TypeParam moved = std::move(original);

  const Eigen::VectorXd x = moved.solve(Eigen::VectorXd::Ones(5));
  EXPECT_TRUE(x.isApprox((Eigen::VectorXd(5) << 2.5, 4, 4.5, 4, 2.5).finished(), 1e-15));
}

TYPED_TEST(SquareSolve, TakesAMatrixThatIsNotCompressed) {
  SparseMatrix A = laplacian(4);
  A.reserve(Eigen::VectorXi::Constant(4, 9));
  ASSERT_FALSE(A.isCompressed());

  const Eigen::VectorXd b = Eigen::VectorXd::Ones(4);

  EXPECT_LT(relative_residual(A, TypeParam(A).solve(b), b), 1e-15);
}

TYPED_TEST(SquareSolve, TakesAnEmptyMatrix) {
  const TypeParam factor{SparseMatrix(0, 0)};

  EXPECT_EQ(factor.rows(), 0);
  EXPECT_EQ(factor.solve(Eigen::VectorXd(0)).size(), 0);
}

TYPED_TEST(SquareSolve, NamesTheEntryThatIsNotFinite) {
  SparseMatrix A = laplacian(4);
  A.coeffRef(2, 1) = std::numeric_limits<double>::quiet_NaN();

  try {
    const TypeParam factor(A);
    FAIL() << "a NaN was factorised";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("entry (2, 1)"));
  }
}

TYPED_TEST(SquareSolve, EstimatesTheConditionWithinAFactorOfThree) {
  for (const Index n : {1, 2, 5, 8}) {
    const double exact = exact_condition(hilbert(n));

    const double estimate = TypeParam(sparse(hilbert(n))).condition_estimate();

    EXPECT_LE(estimate, exact * (1 + 1e-4)) << n;
    EXPECT_GE(estimate, exact / 3) << n;
  }
}

TEST(Cholesky, ReadsTheLowerTriangleOnly) {
  const SparseMatrix full = laplacian(6);
  const SparseMatrix lower = full.triangularView<Eigen::Lower>();
  const Eigen::VectorXd b = random_matrix(6, 1, 1);

  EXPECT_EQ(Cholesky(lower).solve(b), Cholesky(full).solve(b));
  EXPECT_DOUBLE_EQ(Cholesky(lower).condition_estimate(), Cholesky(full).condition_estimate());
}

TEST(Cholesky, AttemptIsEmptyForAnIndefiniteMatrixOfAnySize) {
  for (const Index n : {1, 3, 100}) {
    EXPECT_FALSE(Cholesky::attempt(laplacian_2d(n, -4.5))) << n;
    EXPECT_TRUE(Cholesky::attempt(laplacian_2d(n, 0.0))) << n;
  }
}

TEST(Cholesky, RefusesAnIndefiniteMatrix) {
  EXPECT_THROW(Cholesky(sparse(Eigen::Matrix2d{{1, 2}, {2, 1}})), NumericalError);
}

TEST(Cholesky, RefactorisesNewValuesInTheSamePattern) {
  for (const Index n : {5, 100}) {
    Cholesky factor(laplacian_2d(n, 0.0));
    const SparseMatrix stiffer = laplacian_2d(n, 3.0);
    const Eigen::VectorXd b = random_matrix(n * n, 1, 2);

    factor.refactorize(stiffer);

    EXPECT_LT(relative_residual(stiffer, factor.solve(b), b), 1e-14);
    EXPECT_DOUBLE_EQ(factor.condition_estimate(), Cholesky(stiffer).condition_estimate());
  }
}

TEST(Cholesky, RefactorisesAfterAnIndefiniteMatrix) {
  Cholesky factor(laplacian_2d(5, 0.0));
  EXPECT_THROW(factor.refactorize(laplacian_2d(5, -4.5)), NumericalError);
  const Eigen::VectorXd b = random_matrix(25, 1, 2);

  factor.refactorize(laplacian_2d(5, 1.0));

  EXPECT_LT(relative_residual(laplacian_2d(5, 1.0), factor.solve(b), b), 1e-14);
}

TEST(Cholesky, RefusesToRefactoriseAnotherPattern) {
  Cholesky factor(laplacian(9));

  EXPECT_THROW(factor.refactorize(laplacian_2d(3, 0.0)), std::invalid_argument);
  EXPECT_THROW(factor.refactorize(laplacian(8)), std::invalid_argument);
}

TEST(Lu, SolvesWhereTheDiagonalIsZero) {
  const SparseMatrix A = sparse(Eigen::Matrix3d{{0, 2, 0}, {0, 0, 4}, {8, 0, 0}});

  EXPECT_EQ(Lu(A).solve(Eigen::Vector3d(2, 4, 8)), Eigen::VectorXd(Eigen::Vector3d(1, 1, 1)));
}

TEST(Lu, SolvesWithTheMatrixAndNotItsTranspose) {
  const SparseMatrix A = sparse(Eigen::Matrix2d{{1, 1}, {0, 1}});

  EXPECT_EQ(Lu(A).solve(Eigen::Vector2d(3, 1)), Eigen::VectorXd(Eigen::Vector2d(2, 1)));
}

TEST(Lu, LeavesNoResidualWithAndWithoutRefinement) {
  const SparseMatrix A = sparse(random_matrix(40, 40, 3));
  const Eigen::VectorXd b = random_matrix(40, 1, 4);

  // Threshold pivoting lets entries grow, by how much is the BLAS's order of sums; refinement mends
  // it.
  EXPECT_LT(relative_residual(A, Lu(A, 0).solve(b), b), 1e-10);
  EXPECT_LT(relative_residual(A, Lu(A, 2).solve(b), b), 1e-13);
}

TEST(Lu, EstimatesTheConditionOfAnUnsymmetricMatrix) {
  const Eigen::MatrixXd A = random_matrix(30, 30, 11) + 5.0 * Eigen::MatrixXd::Identity(30, 30);

  const double estimate = Lu(sparse(A)).condition_estimate();

  EXPECT_LE(estimate, exact_condition(A) * (1 + 1e-10));
  EXPECT_GE(estimate, exact_condition(A) / 3);
}

TEST(Lu, RefusesASingularMatrixWithAReason) {
  for (const Eigen::Matrix2d& dense :
       {Eigen::Matrix2d{{1, 2}, {2, 4}}, Eigen::Matrix2d{{0, 0}, {3, 1}}}) {
    try {
      const Lu factor(sparse(dense));
      FAIL() << "a singular matrix was factorised";
    } catch (const NumericalError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("singular"));
    }
  }
}

TEST(SquareMatrices, AreAskedFor) {
  const SparseMatrix wide(2, 3);

  EXPECT_THROW(Lu{wide}, std::invalid_argument);
  EXPECT_THROW(Cholesky{wide}, std::invalid_argument);
  EXPECT_THROW(SymmetricOrGeneral{wide}, std::invalid_argument);
}

struct Choice {
  Eigen::Matrix2d matrix;
  SolverChoice asked;
  SolverChoice chosen;
  const char* reason;
};
class Choosing : public testing::TestWithParam<Choice> {};

TEST_P(Choosing, IsDecidedByTheFactorisation) {
  const SymmetricOrGeneral factor(sparse(GetParam().matrix), GetParam().asked);

  EXPECT_EQ(factor.chosen(), GetParam().chosen);
  EXPECT_THAT(factor.reason(), testing::StartsWith(GetParam().reason));
  const Eigen::Vector2d x = factor.solve(GetParam().matrix * Eigen::Vector2d(1, 2));
  EXPECT_TRUE(x.isApprox(Eigen::Vector2d(1, 2), 1e-15));
}

const Eigen::Matrix2d definite{{2, 1}, {1, 2}};
const Eigen::Matrix2d indefinite{{1, 2}, {2, 1}};
const Eigen::Matrix2d unsymmetric{{2, 1}, {0, 2}};
INSTANTIATE_TEST_SUITE_P(
    , Choosing,
    testing::Values(
        Choice{definite, SolverChoice::automatic, SolverChoice::cholmod, "symmetric and positive"},
        Choice{definite, SolverChoice::cholmod, SolverChoice::cholmod, "symmetric and positive"},
        Choice{definite, SolverChoice::umfpack, SolverChoice::umfpack, "asked for"},
        Choice{indefinite, SolverChoice::automatic, SolverChoice::umfpack,
               "symmetric, not positive"},
        Choice{unsymmetric, SolverChoice::automatic, SolverChoice::umfpack, "not symmetric"}));

TEST(SymmetricOrGeneral, RefusesCholmodWhereItCannotBeAndSaysWhere) {
  const Place place{"bar.toml", 12, 3, "boundary_solver"};

  for (const Eigen::Matrix2d& matrix : {indefinite, unsymmetric}) {
    try {
      const SymmetricOrGeneral factor(sparse(matrix), SolverChoice::cholmod, place);
      FAIL() << "cholmod was accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("bar.toml:12:3: boundary_solver: \"cholmod\""));
      EXPECT_THAT(error.what(), testing::HasSubstr("umfpack"));
    }
  }
}

}  // namespace
}  // namespace tlsph

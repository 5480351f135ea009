/// A solve with a workspace takes nothing from the heap, counted below the C++ and the C allocator:
/// the libraries call malloc.

#include <gtest/gtest.h>

#include "counting_allocator.hpp"
#include "matrices.hpp"
#include "tlsph/linear/factorization.hpp"

#ifdef TLSPH_COUNTS_ALLOCATIONS

namespace tlsph {
namespace {

template <typename Factor>
class SolveInto : public testing::Test {};
using SquareFactors = testing::Types<Cholesky, Lu, SymmetricOrGeneral>;
TYPED_TEST_SUITE(SolveInto, SquareFactors);

TYPED_TEST(SolveInto, AllocatesNothing) {
  for (const Index n : {3, 100}) {  // simplicial and supernodal
    const SparseMatrix A = test::laplacian_2d(n, 0.1);
    const TypeParam factor(A);
    SolveWorkspace workspace = factor.workspace();
    const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
    Eigen::VectorXd x(A.rows());

    const long before = allocations;
    factor.solve_into(b.data(), x.data(), workspace);
    const long during = allocations - before;

    EXPECT_EQ(during, 0) << n;
  }
}

TEST(AllocationCounter, Counts) {
  const long before = allocations;
  const Eigen::VectorXd some(100);
  EXPECT_GT(allocations, before);
}

}  // namespace
}  // namespace tlsph

#endif

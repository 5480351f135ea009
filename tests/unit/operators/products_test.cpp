/// Products of a plain sparse matrix with fields: hand numbers, and what differences are for.

#include "tlsph/operators/products.hpp"

#include <gtest/gtest.h>

namespace tlsph {
namespace {

/// The chain 1 −1; −1 2 −1; −1 1 with a weight that no binary fraction holds.
SparseMatrix chain() {
  SparseMatrix A(3, 3);
  const double w = 0.1;
  for (const auto& [p, q] : {std::pair{0, 1}, std::pair{1, 2}}) {
    A.coeffRef(p, p) += w;
    A.coeffRef(q, q) += w;
    A.coeffRef(p, q) -= w;
    A.coeffRef(q, p) -= w;
  }
  A.makeCompressed();
  return A;
}

VectorField<2> ramp(double offset) {
  VectorField<2> x(3, 2);
  x << offset, 0.0, offset + 1.0, 2.0, offset + 4.0, 6.0;
  return x;
}

TEST(Multiply, GivesTheProduct) {
  VectorField<2> y = VectorField<2>::Constant(3, 2, 7.0);

  multiply<2>(chain(), ramp(0.0), y);

  VectorField<2> expected(3, 2);
  expected << -0.1, -0.2, -0.2, -0.2, 0.3, 0.4;
  EXPECT_LE((y - expected).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(Differences, GiveTheProductWhereRowsSumToZero) {
  VectorField<2> product(3, 2);
  VectorField<2> y = VectorField<2>::Constant(3, 2, 7.0);
  multiply<2>(chain(), ramp(0.0), product);

  multiply_differences<2>(chain(), ramp(0.0), y);
  VectorField<2> rest = VectorField<2>::Constant(3, 2, 1.0);
  subtract_differences<2>(chain(), ramp(0.0), rest);

  EXPECT_LE((y - product).cwiseAbs().maxCoeff(), 1e-16);
  EXPECT_LE((rest + product - VectorField<2>::Ones(3, 2)).cwiseAbs().maxCoeff(), 1e-15);
}

// A thousand kilometres from where it was, metres wide: the plain product errs by 1e-11.
TEST(Differences, DoNotSeeWhereTheBodyIs) {
  VectorField<2> here(3, 2);
  VectorField<2> far(3, 2);

  multiply_differences<2>(chain(), ramp(0.0), here);
  multiply_differences<2>(chain(), ramp(1048576.0), far);

  EXPECT_EQ(here, far);
}

}  // namespace
}  // namespace tlsph

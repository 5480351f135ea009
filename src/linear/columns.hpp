#pragma once
/// \file
/// Systems with several right-hand sides, a column at a time.

#include <cassert>

#include "tlsph/linear/factorization.hpp"

namespace tlsph {

template <class Factor>
Eigen::MatrixXd solve_each_column(const Factor& factor,
                                  const Eigen::Ref<const Eigen::MatrixXd>& b) {
  assert(b.rows() == factor.rows());
  Eigen::MatrixXd x(b.rows(), b.cols());
  SolveWorkspace scratch = factor.workspace();
  for (Index column = 0; column < b.cols(); ++column)
    factor.solve_into(b.col(column).data(), x.col(column).data(), scratch);
  return x;
}

}  // namespace tlsph

#include "tlsph/linear/condition.hpp"

#include <algorithm>
#include <cmath>

namespace tlsph {

double one_norm(const SparseMatrix& A) {
  Eigen::VectorXd column_sums = Eigen::VectorXd::Zero(A.cols());
  for (Index row = 0; row < A.outerSize(); ++row) {
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) {
      column_sums(entry.col()) += std::abs(entry.value());
    }
  }
  return A.cols() > 0 ? column_sums.maxCoeff() : 0.0;
}

double inverse_one_norm(const Inverse& solve, const Inverse& solve_transposed, Index n) {
  if (n == 0) return 0.0;
  constexpr int max_pairs = 5;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  double estimate = 0.0;
  // ‖A⁻¹x‖₁ is convex in x, so its maximum over ‖x‖₁ ≤ 1 is at a unit vector: climb along the
  // gradient A⁻ᵀ sign(A⁻¹x) from one to the next.
  for (int pair = 0; pair < max_pairs; ++pair) {
    const Eigen::VectorXd y = solve(x);
    const double norm = y.lpNorm<1>();
    if (norm <= estimate) break;
    estimate = norm;
    const Eigen::VectorXd signs = y.unaryExpr([](double v) { return v < 0 ? -1.0 : 1.0; });
    const Eigen::VectorXd gradient = solve_transposed(signs);
    Index steepest = 0;
    if (gradient.cwiseAbs().maxCoeff(&steepest) <= gradient.dot(x)) break;
    x = Eigen::VectorXd::Unit(n, steepest);
  }
  Eigen::VectorXd alternating(n);
  for (Index i = 0; i < n; ++i) {
    const double size = n > 1 ? 1.0 + static_cast<double>(i) / static_cast<double>(n - 1) : 1.0;
    alternating(i) = i % 2 == 0 ? size : -size;
  }
  const double sum = alternating.lpNorm<1>();
  return std::max(estimate, solve(alternating).lpNorm<1>() / sum);
}

}  // namespace tlsph

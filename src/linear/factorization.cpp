#include "tlsph/linear/factorization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "suitesparse.hpp"

namespace tlsph {

SolveWorkspace::SolveWorkspace(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SolveWorkspace::~SolveWorkspace() = default;
SolveWorkspace::SolveWorkspace(SolveWorkspace&&) noexcept = default;
SolveWorkspace& SolveWorkspace::operator=(SolveWorkspace&&) noexcept = default;

Factorization::Factorization(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Factorization::~Factorization() = default;
Factorization::Factorization(Factorization&&) noexcept = default;
Factorization& Factorization::operator=(Factorization&&) noexcept = default;

Index Factorization::rows() const {
  return impl_->rows;
}

SolveWorkspace Factorization::workspace() const {
  SolveWorkspace made(std::make_unique<SolveWorkspace::Impl>());
  impl_->prepare(*made.impl_);
  return made;
}

void Factorization::solve_into(const double* rhs, double* x, SolveWorkspace& workspace) const {
  if (rows() > 0) impl_->solve(rhs, x, *workspace.impl_, false);
}

Eigen::MatrixXd Factorization::solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  assert(b.rows() == rows());
  Eigen::MatrixXd x(b.rows(), b.cols());
  SolveWorkspace scratch = workspace();
  for (Index column = 0; column < b.cols(); ++column)
    solve_into(b.col(column).data(), x.col(column).data(), scratch);
  return x;
}

/// A lower bound of ‖A⁻¹‖₁ by at most five pairs of solves (Hager 1984; Higham, ACM TOMS 14, 1988,
/// algorithm 4.1, with his alternating vector against unlucky cancellation).
double Factorization::condition_estimate() const {
  const Index n = rows();
  if (n == 0) return 0.0;
  SolveWorkspace scratch = workspace();
  const auto solve = [&](const Eigen::VectorXd& b, bool transposed) {
    Eigen::VectorXd x(n);
    impl_->solve(b.data(), x.data(), *scratch.impl_, transposed);
    return x;
  };
  constexpr int max_pairs = 5;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
  double estimate = 0.0;
  // ‖A⁻¹x‖₁ is convex in x, so its maximum over ‖x‖₁ ≤ 1 is at a unit vector: climb along the
  // gradient A⁻ᵀ sign(A⁻¹x) from one to the next.
  for (int pair = 0; pair < max_pairs; ++pair) {
    const Eigen::VectorXd y = solve(x, false);
    const double norm = y.lpNorm<1>();
    if (norm <= estimate) break;
    estimate = norm;
    const Eigen::VectorXd signs = y.unaryExpr([](double v) { return v < 0 ? -1.0 : 1.0; });
    const Eigen::VectorXd gradient = solve(signs, true);
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
  return impl_->norm * std::max(estimate, solve(alternating, false).lpNorm<1>() / sum);
}

namespace {

/// Largest |A − Aᵀ| over the largest |A| that rounding of symmetric entries may leave.
constexpr double symmetry_tolerance = 1e-14;

double largest_entry(const SparseMatrix& A) {
  double largest = 0.0;
  for (Index row = 0; row < A.outerSize(); ++row)
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
      largest = std::max(largest, std::abs(entry.value()));
  return largest;
}

double asymmetry(const SparseMatrix& A) {
  const double scale = largest_entry(A);
  const SparseMatrix difference = A - SparseMatrix(A.transpose());
  return scale > 0.0 ? largest_entry(difference) / scale : 0.0;
}

}  // namespace

SymmetricOrGeneral::SymmetricOrGeneral(const SparseMatrix& A, SolverChoice choice,
                                       const Place& place)
    : Factorization(nullptr), reason_("asked for") {
  if (choice != SolverChoice::umfpack) {
    const double difference = A.rows() == A.cols() ? asymmetry(A) : 0.0;
    if (difference > symmetry_tolerance) {
      reason_ = fmt::format("not symmetric: entries differ by {:.1e} of the largest", difference);
    } else if (std::optional<Cholesky> cholesky = Cholesky::attempt(A)) {
      Factorization::operator=(std::move(*cholesky));
      chosen_ = SolverChoice::cholmod;
      reason_ = "symmetric and positive definite";
      return;
    } else {
      reason_ = "symmetric, not positive definite";
    }
    if (choice == SolverChoice::cholmod)
      throw InputError(place, fmt::format("\"cholmod\" wants a symmetric positive definite matrix, "
                                          "and this one is {}; use \"auto\" or \"umfpack\"",
                                          reason_));
  }
  Factorization::operator=(Lu(A));
}

}  // namespace tlsph

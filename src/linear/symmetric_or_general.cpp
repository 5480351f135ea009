#include <fmt/format.h>

#include <cmath>

#include "tlsph/linear/factorization.hpp"

namespace tlsph {
namespace {

/// Largest |A − Aᵀ| over the largest |A| that rounding of symmetric entries may leave.
constexpr double symmetry_tolerance = 1e-14;

double largest_entry(const SparseMatrix& A) {
  double largest = 0.0;
  for (Index row = 0; row < A.outerSize(); ++row) {
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) {
      largest = std::max(largest, std::abs(entry.value()));
    }
  }
  return largest;
}

double asymmetry(const SparseMatrix& A) {
  const double scale = largest_entry(A);
  const SparseMatrix difference = A - SparseMatrix(A.transpose());
  return scale > 0.0 ? largest_entry(difference) / scale : 0.0;
}

}  // namespace

SymmetricOrGeneral::Factor SymmetricOrGeneral::factorise(const SparseMatrix& A, SolverChoice choice,
                                                         const Place& place, std::string& reason) {
  if (choice == SolverChoice::umfpack) {
    reason = "asked for";
    return Lu(A);
  }
  const double difference = A.rows() == A.cols() ? asymmetry(A) : 0.0;
  if (difference <= symmetry_tolerance) {
    if (std::optional<Cholesky> cholesky = Cholesky::attempt(A)) {
      reason = "symmetric and positive definite";
      return std::move(*cholesky);
    }
    reason = "symmetric, not positive definite";
  } else {
    reason = fmt::format("not symmetric: entries differ by {:.1e} of the largest", difference);
  }
  if (choice == SolverChoice::cholmod) {
    throw InputError(place,
                     fmt::format("\"cholmod\" wants a symmetric positive definite matrix, and "
                                 "this one is {}; use \"auto\" or \"umfpack\"",
                                 reason));
  }
  return Lu(A);
}

SymmetricOrGeneral::SymmetricOrGeneral(const SparseMatrix& A, SolverChoice choice,
                                       const Place& place)
    : factor_(factorise(A, choice, place, reason_)) {}

Index SymmetricOrGeneral::rows() const {
  return std::visit([](const auto& factor) { return factor.rows(); }, factor_);
}

SolverChoice SymmetricOrGeneral::chosen() const {
  return std::holds_alternative<Cholesky>(factor_) ? SolverChoice::cholmod : SolverChoice::umfpack;
}

SolveWorkspace SymmetricOrGeneral::workspace() const {
  return std::visit([](const auto& factor) { return factor.workspace(); }, factor_);
}

void SymmetricOrGeneral::solve_into(const double* rhs, double* x, SolveWorkspace& workspace) const {
  std::visit([&](const auto& factor) { factor.solve_into(rhs, x, workspace); }, factor_);
}

double SymmetricOrGeneral::condition_estimate() const {
  return std::visit([](const auto& factor) { return factor.condition_estimate(); }, factor_);
}

}  // namespace tlsph

#include "suitesparse.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace tlsph {

SolveWorkspace::SolveWorkspace(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SolveWorkspace::~SolveWorkspace() = default;
SolveWorkspace::SolveWorkspace(SolveWorkspace&&) noexcept = default;
SolveWorkspace& SolveWorkspace::operator=(SolveWorkspace&&) noexcept = default;

void require_finite(const SparseMatrix& A, const std::string& method) {
  for (Index row = 0; row < A.outerSize(); ++row) {
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) {
      if (!std::isfinite(entry.value())) {
        throw NumericalError(fmt::format("{}: entry ({}, {}) of the matrix is {}", method,
                                         entry.row(), entry.col(), entry.value()),
                             0.0, -1);
      }
    }
  }
}

void require_square(const SparseMatrix& A, const std::string& method) {
  if (A.rows() != A.cols()) {
    throw std::invalid_argument(
        fmt::format("{}: the matrix is {}×{}, not square", method, A.rows(), A.cols()));
  }
}

void throw_failure(const std::string& method, const SparseMatrix& A, const std::string& what) {
  throw NumericalError(fmt::format("{}: cannot factorise a {}×{} matrix with {} non-zeros: {}",
                                   method, A.rows(), A.cols(), A.nonZeros(), what),
                       0.0, -1);
}

}  // namespace tlsph

#include "suitesparse.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>

// Weak: there only if the BLAS that was linked is OpenBLAS.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int);
extern "C" __attribute__((weak)) void dpotrf_(const char*, const int*, double*, const int*, int*);

namespace tlsph {

double one_norm(const SparseMatrix& A) {
  Eigen::VectorXd column_sums = Eigen::VectorXd::Zero(A.cols());
  for (Index row = 0; row < A.outerSize(); ++row)
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
      column_sums(entry.col()) += std::abs(entry.value());
  return A.cols() > 0 ? column_sums.maxCoeff() : 0.0;
}

void require_finite(const SparseMatrix& A, const std::string& method) {
  for (Index row = 0; row < A.outerSize(); ++row)
    for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry)
      if (!std::isfinite(entry.value()))
        throw NumericalError(fmt::format("{}: entry ({}, {}) of the matrix is {}", method,
                                         entry.row(), entry.col(), entry.value()),
                             0.0, -1);
}

void require_square(const SparseMatrix& A, const std::string& method) {
  if (A.rows() != A.cols())
    throw std::invalid_argument(
        fmt::format("{}: the matrix is {}×{}, not square", method, A.rows(), A.cols()));
}

void throw_failure(const std::string& method, const SparseMatrix& A, const std::string& what) {
  throw NumericalError(fmt::format("{}: cannot factorise a {}×{} matrix with {} non-zeros: {}",
                                   method, A.rows(), A.cols(), A.nonZeros(), what),
                       0.0, -1);
}

void set_blas_threads(int threads) {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(threads);
}

void reserve_blas_memory() {
  /// OpenBLAS, as Debian builds it, takes this much at the first call of a thread.
  constexpr std::size_t work_space = (std::size_t{128} << 20) + (std::size_t{1} << 20);
  static const bool reserved = [] {
    if (openblas_set_num_threads == nullptr || dpotrf_ == nullptr) return false;
    void* volatile block = std::malloc(work_space);  // volatile: or no compiler would try
    if (block == nullptr) throw std::bad_alloc();
    std::free(block);
    const int one = 1;
    double entry = 1.0;
    int info = 0;
    dpotrf_("L", &one, &entry, &one, &info);
    return info == 0;
  }();
  (void)reserved;
}

}  // namespace tlsph

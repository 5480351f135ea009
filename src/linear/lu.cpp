#include <fmt/format.h>
#include <umfpack.h>

#include <array>
#include <new>
#include <string>
#include <utility>

#include "suitesparse.hpp"

namespace tlsph {
namespace {

constexpr auto method = "LU (UMFPACK)";

std::string explain(int status) {
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  return status == UMFPACK_WARNING_singular_matrix ? "it is singular"
                                                   : fmt::format("status {}", status);
}

}  // namespace

struct Lu::Factor : Factorization::Impl {
  /// By columns, kept for the residuals of the refinement.
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> matrix;
  void* numeric = nullptr;
  std::array<double, UMFPACK_CONTROL> control{};

  Factor(const SparseMatrix& A, int refinement_steps) : matrix(A) {
    rows = A.rows();
    norm = one_norm(A);
    umfpack_di_defaults(control.data());
    control[UMFPACK_PRL] = 0;
    control[UMFPACK_IRSTEP] = refinement_steps;
    if (rows == 0) return;
    matrix.makeCompressed();
    reserve_blas_memory();
    const int n = static_cast<int>(rows);
    void* symbolic = nullptr;
    int status = umfpack_di_symbolic(n, n, matrix.outerIndexPtr(), matrix.innerIndexPtr(),
                                     matrix.valuePtr(), &symbolic, control.data(), nullptr);
    if (status == UMFPACK_OK)
      status = umfpack_di_numeric(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(),
                                  symbolic, &numeric, control.data(), nullptr);
    umfpack_di_free_symbolic(&symbolic);
    if (status == UMFPACK_OK) return;
    umfpack_di_free_numeric(&numeric);
    throw_failure(method, A, explain(status));
  }
  ~Factor() override { umfpack_di_free_numeric(&numeric); }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  void prepare(SolveWorkspace::Impl& scratch) const override {
    const auto n = static_cast<std::size_t>(rows);
    scratch.indices.resize(n);
    scratch.values.resize(control[UMFPACK_IRSTEP] > 0 ? 5 * n : n);
  }

  void solve(const double* rhs, double* x, SolveWorkspace::Impl& scratch,
             bool transposed) const override {
    std::array<double, UMFPACK_INFO> info{};
    const int status = umfpack_di_wsolve(
        transposed ? UMFPACK_Aat : UMFPACK_A, matrix.outerIndexPtr(), matrix.innerIndexPtr(),
        matrix.valuePtr(), x, rhs, numeric, control.data(), info.data(), scratch.indices.data(),
        scratch.values.data());
    if (status != UMFPACK_OK)
      throw NumericalError(fmt::format("{}: the solve failed: {}", method, explain(status)), 0.0,
                           -1);
  }
};

Lu::Lu(const SparseMatrix& A, int refinement_steps) : Factorization(nullptr) {
  require_square(A, method);
  require_finite(A, method);
  impl_ = std::make_unique<Factor>(A, refinement_steps);
}

}  // namespace tlsph

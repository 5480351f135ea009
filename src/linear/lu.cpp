#include <fmt/format.h>
#include <umfpack.h>

#include <array>
#include <new>
#include <string>
#include <utility>

#include "columns.hpp"
#include "suitesparse.hpp"
#include "tlsph/linear/condition.hpp"

namespace tlsph {
namespace {

constexpr auto method = "LU (UMFPACK)";

using ByColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

std::string explain(int status) {
  if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  return status == UMFPACK_WARNING_singular_matrix ? "it is singular"
                                                   : fmt::format("status {}", status);
}

}  // namespace

struct Lu::Impl {
  ByColumns matrix;  // kept for the residuals of the refinement
  void* numeric = nullptr;
  std::array<double, UMFPACK_CONTROL> control{};
  double norm = 0;

  Impl() = default;
  ~Impl() { umfpack_di_free_numeric(&numeric); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] bool refines() const { return control[UMFPACK_IRSTEP] > 0; }

  void factorise(const SparseMatrix& A) {
    reserve_blas_memory();
    const int n = static_cast<int>(A.rows());
    void* symbolic = nullptr;
    int status = umfpack_di_symbolic(n, n, matrix.outerIndexPtr(), matrix.innerIndexPtr(),
                                     matrix.valuePtr(), &symbolic, control.data(), nullptr);
    if (status == UMFPACK_OK) {
      status = umfpack_di_numeric(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(),
                                  symbolic, &numeric, control.data(), nullptr);
    }
    umfpack_di_free_symbolic(&symbolic);
    if (status != UMFPACK_OK) throw_failure(method, A, explain(status));
  }

  void solve(int system, const double* rhs, double* x, SolveWorkspace::Impl& scratch) const {
    if (matrix.rows() == 0) return;
    std::array<double, UMFPACK_INFO> info{};
    const int status = umfpack_di_wsolve(
        system, matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(), x, rhs, numeric,
        control.data(), info.data(), scratch.indices.data(), scratch.values.data());
    if (status != UMFPACK_OK) {
      throw NumericalError(fmt::format("{}: the solve failed: {}", method, explain(status)), 0.0,
                           -1);
    }
  }
};

Lu::Lu(const SparseMatrix& A, int refinement_steps) : impl_(std::make_unique<Impl>()) {
  require_square(A, method);
  require_finite(A, method);
  umfpack_di_defaults(impl_->control.data());
  impl_->control[UMFPACK_PRL] = 0;
  impl_->control[UMFPACK_IRSTEP] = refinement_steps;
  impl_->matrix = A;
  impl_->matrix.makeCompressed();
  impl_->norm = one_norm(A);
  if (A.rows() > 0) impl_->factorise(A);
}

Lu::~Lu() = default;
Lu::Lu(Lu&&) noexcept = default;
Lu& Lu::operator=(Lu&&) noexcept = default;

Index Lu::rows() const {
  return impl_->matrix.rows();
}

SolveWorkspace Lu::workspace() const {
  auto scratch = std::make_unique<SolveWorkspace::Impl>();
  const auto n = static_cast<std::size_t>(rows());
  scratch->indices.resize(n);
  scratch->values.resize(impl_->refines() ? 5 * n : n);
  return SolveWorkspace(std::move(scratch));
}

void Lu::solve_into(const double* rhs, double* x, SolveWorkspace& workspace) const {
  impl_->solve(UMFPACK_A, rhs, x, *workspace.impl_);
}

Eigen::MatrixXd Lu::solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  return solve_each_column(*this, b);
}

double Lu::condition_estimate() const {
  SolveWorkspace scratch = workspace();
  const auto inverse = [&](int system) -> Inverse {
    return [&, system](const Eigen::VectorXd& b) {
      Eigen::VectorXd x(rows());
      impl_->solve(system, b.data(), x.data(), *scratch.impl_);
      return x;
    };
  };
  return impl_->norm * inverse_one_norm(inverse(UMFPACK_A), inverse(UMFPACK_Aat), rows());
}

}  // namespace tlsph

#include <fmt/format.h>

#include <cassert>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <utility>

#include "columns.hpp"
#include "suitesparse.hpp"
#include "tlsph/linear/condition.hpp"

namespace tlsph {
namespace {

constexpr auto method = "Cholesky (CHOLMOD)";

SparseMatrix compressed(SparseMatrix A) {
  A.makeCompressed();
  return A;
}

/// A simplicial solve takes room for four right-hand sides, stored side by side in each column, and
/// leaves it reshaped to those it had; the next one would take another block from the heap unless
/// it finds the first in its first shape.
void restore_shape(cholmod_dense* block) {
  if (block == nullptr) return;
  block->nrow = 4;
  block->ncol = block->nzmax / block->nrow;
  block->d = block->nrow;
}

/// FNV-1a of the row starts and column indices.
std::uint64_t pattern_hash(const SparseMatrix& A) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](const int* data, Index count) {
    for (Index k = 0; k < count; ++k) {
      hash = (hash ^ static_cast<std::uint32_t>(data[k])) * 0x100000001b3u;
    }
  };
  add(A.outerIndexPtr(), A.outerSize() + 1);
  add(A.innerIndexPtr(), A.nonZeros());
  return hash;
}

/// ‖A‖₁ of the symmetric matrix whose lower triangle is stored.
double symmetric_one_norm(const SparseMatrix& A) {
  const SparseMatrix full = A.selfadjointView<Eigen::Lower>();
  return one_norm(full);
}

}  // namespace

struct Cholesky::Impl {
  CholmodState state;
  cholmod_factor* factor = nullptr;
  Index rows = 0;
  std::uint64_t pattern = 0;
  double norm = 0;
  bool solvable = false;

  Impl() = default;
  ~Impl() { cholmod_free_factor(&factor, state.get()); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void analyse(const SparseMatrix& A) {
    rows = A.rows();
    pattern = pattern_hash(A);
    if (rows == 0) return;
    state.get()->final_ll = 1;  // L Lᵀ: an L D Lᵀ with negative pivots must not pass for success
    state.get()->quick_return_if_not_posdef = 1;
    cholmod_sparse view = sparse_view(A);
    factor = cholmod_analyze(&view, state.get());
    if (factor == nullptr) fail(A);
  }

  /// False when A is not positive definite.
  bool factorise(const SparseMatrix& A) {
    solvable = rows == 0;
    if (solvable) return true;
    reserve_blas_memory();
    cholmod_sparse view = sparse_view(A);
    cholmod_factorize(&view, factor, state.get());
    if (state.get()->status < CHOLMOD_OK) fail(A);
    solvable = state.get()->status == CHOLMOD_OK && factor->minor == factor->n;
    if (solvable) norm = symmetric_one_norm(A);
    return solvable;
  }

  [[noreturn]] void fail(const SparseMatrix& A) {
    const int status = state.get()->status;
    // A factor of more than 2³¹ entries is too large for the indices.
    if (status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    throw_failure(method, A, fmt::format("status {}", status));
  }
};

namespace {

[[noreturn]] void throw_indefinite(const SparseMatrix& A) {
  throw_failure(method, A, "it is not positive definite");
}

}  // namespace

Cholesky::Cholesky(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

std::optional<Cholesky> Cholesky::attempt(const SparseMatrix& A) {
  require_square(A, method);
  require_finite(A, method);
  if (!A.isCompressed()) return attempt(compressed(A));
  auto impl = std::make_unique<Impl>();
  impl->analyse(A);
  if (!impl->factorise(A)) return std::nullopt;
  return Cholesky(std::move(impl));
}

Cholesky::Cholesky(const SparseMatrix& A) {
  std::optional<Cholesky> factorised = attempt(A);
  if (!factorised) throw_indefinite(A);
  *this = std::move(*factorised);
}

void Cholesky::refactorize(const SparseMatrix& A) {
  if (!A.isCompressed()) return refactorize(compressed(A));
  if (A.rows() != impl_->rows || A.cols() != impl_->rows || pattern_hash(A) != impl_->pattern) {
    throw std::invalid_argument(
        fmt::format("{}: refactorize wants the pattern of non-zeros it was analysed for", method));
  }
  require_finite(A, method);
  if (!impl_->factorise(A)) throw_indefinite(A);
}

Index Cholesky::rows() const {
  return impl_->rows;
}

SolveWorkspace Cholesky::workspace() const {
  auto impl = std::make_unique<SolveWorkspace::Impl>();
  SolveWorkspace made(std::move(impl));
  // A first solve leaves CHOLMOD's scratch behind at its full size.
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(rows());
  Eigen::VectorXd unused(rows());
  solve_into(zero.data(), unused.data(), made);
  return made;
}

void Cholesky::solve_into(const double* rhs, double* x, SolveWorkspace& workspace) const {
  assert(impl_->solvable);
  if (rows() == 0) return;
  cholmod_dense b = dense_view(rhs, rows(), 1);
  cholmod_dense solution = dense_view(x, rows(), 1);
  cholmod_dense* solution_handle = &solution;
  SolveWorkspace::Impl& scratch = *workspace.impl_;
  if (impl_->factor->is_super == 0) restore_shape(scratch.permuted);
  if (cholmod_solve2(CHOLMOD_A, impl_->factor, &b, nullptr, &solution_handle, nullptr,
                     &scratch.permuted, &scratch.supernode, scratch.state.get()) == 0) {
    throw NumericalError(
        fmt::format("{}: the solve failed with status {}", method, scratch.state.get()->status),
        0.0, -1);
  }
  assert(solution_handle == &solution);
}

Eigen::MatrixXd Cholesky::solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  return solve_each_column(*this, b);
}

double Cholesky::condition_estimate() const {
  SolveWorkspace scratch = workspace();
  const Inverse inverse = [&](const Eigen::VectorXd& b) {
    Eigen::VectorXd x(rows());
    solve_into(b.data(), x.data(), scratch);
    return x;
  };
  return impl_->norm * inverse_one_norm(inverse, inverse, rows());
}

}  // namespace tlsph

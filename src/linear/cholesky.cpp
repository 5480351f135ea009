#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <ctime>
#include <new>
#include <stdexcept>
#include <utility>

#include "suitesparse.hpp"

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
    for (Index k = 0; k < count; ++k)
      hash = (hash ^ static_cast<std::uint32_t>(data[k])) * 0x100000001b3u;
  };
  add(A.outerIndexPtr(), A.outerSize() + 1);
  add(A.innerIndexPtr(), A.nonZeros());
  return hash;
}

[[noreturn]] void throw_status(const SparseMatrix& A, int status) {
  // A factor of more than 2³¹ entries is too large for the indices.
  if (status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
  throw_failure(method, A, fmt::format("status {}", status));
}

[[noreturn]] void throw_indefinite(const SparseMatrix& A) {
  throw_failure(method, A, "it is not positive definite");
}

/// A factor with its order and symbolic analysis; values are not looked at.
struct Analysed {
  CholmodState state;
  cholmod_factor* factor = nullptr;

  explicit Analysed(const SparseMatrix& A) {
    if (A.rows() == 0) return;
    state.get()->final_ll = 1;  // L Lᵀ: an L D Lᵀ with negative pivots must not pass for success
    state.get()->quick_return_if_not_posdef = 1;
    cholmod_sparse view = sparse_view(A);
    factor = cholmod_analyze(&view, state.get());
    if (factor == nullptr) throw_status(A, state.get()->status);
  }
  ~Analysed() { cholmod_free_factor(&factor, state.get()); }
  Analysed(const Analysed&) = delete;
  Analysed& operator=(const Analysed&) = delete;
};

}  // namespace

struct Cholesky::Factor : Factorization::Impl {
  Analysed analysed;
  std::uint64_t pattern;
  bool solvable = false;

  explicit Factor(const SparseMatrix& A) : analysed(A), pattern(pattern_hash(A)) {
    rows = A.rows();
  }

  /// False when A is not positive definite.
  bool factorise(const SparseMatrix& A) {
    solvable = rows == 0;
    if (solvable) return true;
    reserve_blas_memory();
    cholmod_sparse view = sparse_view(A);
    cholmod_common* state = analysed.state.get();
    cholmod_factorize(&view, analysed.factor, state);
    if (state->status < CHOLMOD_OK) throw_status(A, state->status);
    solvable = state->status == CHOLMOD_OK && analysed.factor->minor == analysed.factor->n;
    if (solvable) norm = one_norm(A.selfadjointView<Eigen::Lower>());
    return solvable;
  }

  void prepare(SolveWorkspace::Impl& scratch) const override {
    // A first solve leaves CHOLMOD's scratch behind at its full size.
    if (rows == 0) return;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(rows);
    Eigen::VectorXd unused(rows);
    solve(zero.data(), unused.data(), scratch, false);
  }

  void solve(const double* rhs, double* x, SolveWorkspace::Impl& scratch,
             bool /*transposed*/) const override {
    assert(solvable);
    cholmod_dense b = dense_view(rhs, rows);
    cholmod_dense solution = dense_view(x, rows);
    cholmod_dense* solution_handle = &solution;
    cholmod_common* state = scratch.state.get();
    if (analysed.factor->is_super == 0) restore_shape(scratch.permuted);
    if (cholmod_solve2(CHOLMOD_A, analysed.factor, &b, nullptr, &solution_handle, nullptr,
                       &scratch.permuted, &scratch.supernode, state) == 0)
      throw NumericalError(
          fmt::format("{}: the solve failed with status {}", method, state->status), 0.0, -1);
    assert(solution_handle == &solution);
  }
};

std::optional<Cholesky> Cholesky::attempt(const SparseMatrix& A) {
  require_square(A, method);
  require_finite(A, method);
  if (!A.isCompressed()) return attempt(compressed(A));
  auto factor = std::make_unique<Factor>(A);
  if (!factor->factorise(A)) return std::nullopt;
  return Cholesky(std::move(factor));
}

Cholesky::Cholesky(const SparseMatrix& A) : Factorization(nullptr) {
  std::optional<Cholesky> factorised = attempt(A);
  if (!factorised) throw_indefinite(A);
  *this = std::move(*factorised);
}

void Cholesky::refactorize(const SparseMatrix& A) {
  if (!A.isCompressed()) return refactorize(compressed(A));
  auto& factor = static_cast<Factor&>(*impl_);
  if (A.rows() != rows() || A.cols() != rows() || pattern_hash(A) != factor.pattern)
    throw std::invalid_argument(
        fmt::format("{}: refactorize wants the pattern of non-zeros it was analysed for", method));
  require_finite(A, method);
  if (!factor.factorise(A)) throw_indefinite(A);
}

FactorCost factor_cost(const SparseMatrix& A) {
  require_square(A, method);
  if (!A.isCompressed()) return factor_cost(compressed(A));
  FactorCost cost;
  cost.rows = A.rows();
  if (A.rows() == 0) return cost;
  Analysed analysed(A);
  const cholmod_factor& factor = *analysed.factor;
  cost.entries = analysed.state.get()->lnz;
  cost.flops = analysed.state.get()->fl;
  const auto stored = static_cast<double>(factor.xsize);
  const double values = factor.is_super != 0 ? std::max(stored, cost.entries) : cost.entries;
  // The factor; the update of the largest supernode; the matrix in the order of elimination, twice.
  cost.bytes = 8.0 * (values + static_cast<double>(factor.maxcsize)) +
               4.0 * static_cast<double>(factor.ssize) + 24.0 * static_cast<double>(A.nonZeros());
  if (factor.is_super == 0) cost.bytes += 4.0 * cost.entries;
  return cost;
}

double factorisation_speed() {
  constexpr Index front = 800;  // a front of the systems that take long has about as many rows
  constexpr int repetitions = 3;
  // Of this process, so that others on the machine do not count.
  const auto processor_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  Eigen::MatrixXd dense = Eigen::MatrixXd::Constant(front, front, 0.5);
  dense.diagonal().setConstant(static_cast<double>(front));
  const SparseMatrix lower = dense.triangularView<Eigen::Lower>().toDenseMatrix().sparseView();
  Cholesky factor(lower);  // the first one finds its memory
  const double start = processor_seconds();
  for (int k = 0; k < repetitions; ++k) factor.refactorize(lower);
  const double seconds = processor_seconds() - start;
  const auto n = static_cast<double>(front);
  return repetitions * n * n * n / 3 / seconds;
}

}  // namespace tlsph

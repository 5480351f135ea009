#pragma once
/// \file
/// What the sources of this room share of SuiteSparse: its state as a scope, views of matrices, and
/// what lies behind a factorisation and a workspace.

#include <cholmod.h>

#include <cassert>
#include <string>
#include <type_traits>
#include <vector>

#include "tlsph/linear/factorization.hpp"

namespace tlsph {

/// CHOLMOD's state, which every call writes to: one for each thread. Silent; problems are read from
/// `status`.
template <auto start, auto finish>
class CommonScope {
 public:
  CommonScope() {
    start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~CommonScope() { finish(&common_); }
  CommonScope(const CommonScope&) = delete;
  CommonScope& operator=(const CommonScope&) = delete;

  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_{};
};
using CholmodState = CommonScope<cholmod_start, cholmod_finish>;

struct SolveWorkspace::Impl {
  CholmodState state;
  cholmod_dense* permuted = nullptr;
  cholmod_dense* supernode = nullptr;
  std::vector<int> indices;
  std::vector<double> values;

  Impl() = default;
  ~Impl() {
    cholmod_free_dense(&permuted, state.get());
    cholmod_free_dense(&supernode, state.get());
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
};

/// A factorised matrix A (rows × rows).
struct Factorization::Impl {
  Index rows = 0;
  double norm = 0.0;  ///< ‖A‖₁

  virtual ~Impl() = default;
  /// Makes scratch as large as solves need it.
  virtual void prepare(SolveWorkspace::Impl& scratch) const = 0;
  /// x = A⁻¹ b, or A⁻ᵀ b.
  virtual void solve(const double* b, double* x, SolveWorkspace::Impl& scratch,
                     bool transposed) const = 0;
};

/// A dense column seen by CHOLMOD; the data stay where they are.
inline cholmod_dense dense_view(const double* data, Index rows) {
  cholmod_dense view{};
  view.nrow = view.nzmax = view.d = static_cast<std::size_t>(rows);
  view.ncol = 1;
  view.x = const_cast<double*>(data);
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

/// A general matrix by columns, or a symmetric one by rows: the rows of its lower triangle are the
/// columns of its upper triangle stored by columns, which is what CHOLMOD calls stype = 1; so A is
/// handed over as it lies in memory.
template <class Matrix>
cholmod_sparse sparse_view(const Matrix& A) {
  using Stored = typename Matrix::StorageIndex;
  assert(A.isCompressed());
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(A.rows());
  view.ncol = static_cast<std::size_t>(A.cols());
  view.nzmax = static_cast<std::size_t>(A.nonZeros());
  view.p = const_cast<Stored*>(A.outerIndexPtr());
  view.i = const_cast<Stored*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = Matrix::IsRowMajor ? 1 : 0;
  view.itype = std::is_same_v<Stored, int> ? CHOLMOD_INT : CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

/// Largest column sum of |A|.
[[nodiscard]] double one_norm(const SparseMatrix& A);

/// Throws unless A holds finite values only, and is square where that is asked for.
void require_finite(const SparseMatrix& A, const std::string& method);
void require_square(const SparseMatrix& A, const std::string& method);

/// Takes the work space of OpenBLAS, once. Where that cannot be had this is std::bad_alloc;
/// OpenBLAS itself would retry forever. For the thread that calls first.
void reserve_blas_memory();

/// Throws NumericalError: the matrix cannot be factorised, and why.
[[noreturn]] void throw_failure(const std::string& method, const SparseMatrix& A,
                                const std::string& what);

}  // namespace tlsph

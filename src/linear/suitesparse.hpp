#pragma once
/// \file
/// What the sources of this room share of SuiteSparse: its state as a scope, and the workspace.

#include <cholmod.h>

#include <cassert>
#include <string>
#include <vector>

#include "tlsph/linear/factorization.hpp"

namespace tlsph {

/// CHOLMOD's state, which every call writes to: one for each thread. Silent; problems are read from
/// `status`.
class CholmodState {
 public:
  CholmodState() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~CholmodState() { cholmod_finish(&common_); }
  CholmodState(const CholmodState&) = delete;
  CholmodState& operator=(const CholmodState&) = delete;

  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_{};
};

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

/// A dense column-major block seen by CHOLMOD; the data stay where they are.
inline cholmod_dense dense_view(const double* data, Index rows, Index columns) {
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(rows);
  view.ncol = static_cast<std::size_t>(columns);
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = const_cast<double*>(data);
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

/// The rows of A's lower triangle, stored by rows, are the columns of its upper triangle stored by
/// columns, which is what CHOLMOD calls stype = 1; so A is handed over as it lies in memory.
inline cholmod_sparse sparse_view(const SparseMatrix& A) {
  assert(A.isCompressed());
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(A.rows());
  view.ncol = static_cast<std::size_t>(A.cols());
  view.nzmax = static_cast<std::size_t>(A.nonZeros());
  view.p = const_cast<int*>(A.outerIndexPtr());
  view.i = const_cast<int*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = 1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

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

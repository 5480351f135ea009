#include <fmt/format.h>

#include <SuiteSparseQR.hpp>
#include <cassert>
#include <new>

#include "suitesparse.hpp"

namespace tlsph {
namespace {

constexpr auto method = "QR (SPQR)";

}  // namespace

struct LeastNorm::Impl {
  explicit Impl(const SparseMatrix& transposed)
      : unknowns(transposed.rows()), conditions(transposed.cols()) {
    reserve_blas_memory();
    // SPQR takes long indices only.
    const Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long> by_columns = transposed;
    cholmod_sparse view = sparse_view(by_columns);
    factors =
        SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, SPQR_NO_TOL, &view, state.get());
    if (factors == nullptr) fail();
    if (factors->rank >= conditions) return;
    SuiteSparseQR_free(&factors, state.get());  // no destructor after an exception of this one
    throw_failure(method, transposed, "its columns depend on each other");
  }
  ~Impl() { SuiteSparseQR_free(&factors, state.get()); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// The columns of what a call of SPQR gave, which is freed.
  Eigen::VectorXd take(cholmod_dense* result) {
    if (result == nullptr) fail();
    Eigen::VectorXd copy = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(result->x),
                                                             static_cast<Index>(result->nrow));
    cholmod_l_free_dense(&result, state.get());
    return copy;
  }

  [[noreturn]] void fail() {
    if (state.get()->status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    throw NumericalError(fmt::format("{}: status {}", method, state.get()->status), 0.0, -1);
  }

  CommonScope<cholmod_l_start, cholmod_l_finish> state;  // for long indices
  Index unknowns, conditions;
  SuiteSparseQR_factorization<double>* factors = nullptr;
};

LeastNorm::LeastNorm(const SparseMatrix& transposed) {
  if (transposed.rows() < transposed.cols())
    throw_failure(method, transposed, "it has fewer rows than columns");
  require_finite(transposed, method);
  impl_ = std::make_shared<Impl>(transposed);
}

Eigen::VectorXd LeastNorm::solve(const Eigen::VectorXd& b) {
  assert(b.size() == impl_->conditions);
  // Aᵀ E = Q [R; 0], so A x = b has the shortest solution x = Q [R⁻ᵀ Eᵀ b; 0].
  cholmod_dense right = dense_view(b.data(), b.size());
  Eigen::VectorXd y = impl_->take(
      SuiteSparseQR_solve(SPQR_RTX_EQUALS_ETB, impl_->factors, &right, impl_->state.get()));
  y.conservativeResize(impl_->unknowns);
  y.tail(impl_->unknowns - impl_->conditions).setZero();
  cholmod_dense coordinates = dense_view(y.data(), y.size());
  return impl_->take(
      SuiteSparseQR_qmult(SPQR_QX, impl_->factors, &coordinates, impl_->state.get()));
}

}  // namespace tlsph

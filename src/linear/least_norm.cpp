#include <fmt/format.h>

#include <SuiteSparseQR.hpp>
#include <cassert>
#include <new>

#include "suitesparse.hpp"

namespace tlsph {
namespace {

constexpr auto method = "QR (SPQR)";

/// SPQR takes long indices only.
using ByColumns = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;

/// CHOLMOD's state for long indices.
class LongState {
 public:
  LongState() {
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.error_handler = nullptr;
  }
  ~LongState() { cholmod_l_finish(&common_); }
  LongState(const LongState&) = delete;
  LongState& operator=(const LongState&) = delete;

  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_{};
};

cholmod_sparse long_view(const ByColumns& A) {
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(A.rows());
  view.ncol = static_cast<std::size_t>(A.cols());
  view.nzmax = static_cast<std::size_t>(A.nonZeros());
  view.p = const_cast<SuiteSparse_long*>(A.outerIndexPtr());
  view.i = const_cast<SuiteSparse_long*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = 0;
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

}  // namespace

struct LeastNorm::Impl {
  explicit Impl(const SparseMatrix& transposed) {
    reserve_blas_memory();
    ByColumns by_columns = transposed;
    by_columns.makeCompressed();
    cholmod_sparse view = long_view(by_columns);
    factors =
        SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, SPQR_NO_TOL, &view, state.get());
    if (factors == nullptr) fail();
    unknowns = transposed.rows();
    conditions = transposed.cols();
    if (factors->rank < conditions)
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

  LongState state;
  Index unknowns = 0, conditions = 0;
  SuiteSparseQR_factorization<double>* factors = nullptr;
};

LeastNorm::LeastNorm(const SparseMatrix& transposed) {
  if (transposed.rows() < transposed.cols())
    throw_failure(method, transposed, "it has fewer rows than columns");
  require_finite(transposed, method);
  impl_ = std::make_unique<Impl>(transposed);
}

LeastNorm::~LeastNorm() = default;
LeastNorm::LeastNorm(LeastNorm&&) noexcept = default;
LeastNorm& LeastNorm::operator=(LeastNorm&&) noexcept = default;

Eigen::VectorXd LeastNorm::solve(const Eigen::VectorXd& b) {
  assert(b.size() == impl_->conditions);
  // Aᵀ E = Q [R; 0], so A x = b has the shortest solution x = Q [R⁻ᵀ Eᵀ b; 0].
  cholmod_dense right = dense_view(b.data(), b.size(), 1);
  Eigen::VectorXd y = impl_->take(
      SuiteSparseQR_solve(SPQR_RTX_EQUALS_ETB, impl_->factors, &right, impl_->state.get()));
  y.conservativeResize(impl_->unknowns);
  y.tail(impl_->unknowns - impl_->conditions).setZero();
  cholmod_dense coordinates = dense_view(y.data(), y.size(), 1);
  return impl_->take(
      SuiteSparseQR_qmult(SPQR_QX, impl_->factors, &coordinates, impl_->state.get()));
}

}  // namespace tlsph

#include <SuiteSparseQR.hpp>
#include <cassert>
#include <optional>
#include <utility>

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

cholmod_sparse sparse_view(const ByColumns& A) {
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

/// A E = Q R with Q kept as Householder vectors.
class Orthogonal {
 public:
  explicit Orthogonal(const SparseMatrix& A) : rows_(A.rows()), cols_(A.cols()) {
    ByColumns by_columns = A;
    by_columns.makeCompressed();
    cholmod_sparse view = sparse_view(by_columns);
    factors_ = SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, SPQR_DEFAULT_TOL, &view,
                                               state_.get());
    if (factors_ == nullptr) {
      throw_failure(method, A,
                    state_.get()->status == CHOLMOD_OUT_OF_MEMORY
                        ? "out of memory"
                        : "status " + std::to_string(state_.get()->status));
    }
    rank_ = static_cast<Index>(factors_->rank);
  }
  ~Orthogonal() { SuiteSparseQR_free(&factors_, state_.get()); }
  Orthogonal(const Orthogonal&) = delete;
  Orthogonal& operator=(const Orthogonal&) = delete;

  [[nodiscard]] Index rank() const { return rank_; }

  /// The basic solution: cols − rank of its entries are zero.
  [[nodiscard]] Eigen::MatrixXd least_squares(const Eigen::MatrixXd& b) const {
    LongState state;
    const Eigen::MatrixXd projected = take(multiply(SPQR_QTX, b, state), rows_, state);
    cholmod_dense view = dense_view(projected.data(), rows_, projected.cols());
    cholmod_dense* x = SuiteSparseQR_solve(SPQR_RETX_EQUALS_B, factors_, &view, state.get());
    return take(x, cols_, state);
  }

  /// Q₁ Q₁ᵀ x, the part of x in the range of A (Q₁ = the first `rank` columns of Q).
  [[nodiscard]] Eigen::MatrixXd project_on_range(const Eigen::MatrixXd& x) const {
    LongState state;
    Eigen::MatrixXd coordinates = take(multiply(SPQR_QTX, x, state), rows_, state);
    coordinates.bottomRows(rows_ - rank_).setZero();
    return take(multiply(SPQR_QX, coordinates, state), rows_, state);
  }

 private:
  cholmod_dense* multiply(int kind, const Eigen::MatrixXd& b, LongState& state) const {
    assert(b.rows() == rows_);
    cholmod_dense view = dense_view(b.data(), b.rows(), b.cols());
    return SuiteSparseQR_qmult(kind, factors_, &view, state.get());
  }

  static Eigen::MatrixXd take(cholmod_dense* result, Index rows, LongState& state) {
    if (result == nullptr) {
      throw NumericalError(std::string(method) + ": the solve failed, out of memory", 0.0, -1);
    }
    Eigen::MatrixXd copy = Eigen::Map<const Eigen::MatrixXd>(
        static_cast<const double*>(result->x), rows, static_cast<Index>(result->ncol));
    cholmod_l_free_dense(&result, state.get());
    return copy;
  }

  Index rows_;
  Index cols_;
  Index rank_ = 0;
  LongState state_;
  SuiteSparseQR_factorization<double>* factors_ = nullptr;
};

}  // namespace

/// The basic solution lies anywhere in (solutions) = x₀ + null(A); its part in the range of Aᵀ, the
/// complement of the null space, is the shortest. Full column rank has one solution only.
struct LeastSquares::Impl {
  explicit Impl(const SparseMatrix& A) : rows(A.rows()), cols(A.cols()), columns(A) {
    if (columns.rank() < cols) row_space.emplace(SparseMatrix(A.transpose()));
  }
  Index rows;
  Index cols;
  Orthogonal columns;
  std::optional<Orthogonal> row_space;
};

LeastSquares::LeastSquares(const SparseMatrix& A) {
  require_finite(A, method);
  impl_ = std::make_unique<Impl>(A);
}

LeastSquares::~LeastSquares() = default;
LeastSquares::LeastSquares(LeastSquares&&) noexcept = default;
LeastSquares& LeastSquares::operator=(LeastSquares&&) noexcept = default;

Index LeastSquares::rows() const {
  return impl_->rows;
}
Index LeastSquares::cols() const {
  return impl_->cols;
}
Index LeastSquares::rank() const {
  return impl_->columns.rank();
}

Eigen::MatrixXd LeastSquares::solve_columns(const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  assert(b.rows() == rows());
  const Eigen::MatrixXd basic = impl_->columns.least_squares(b);
  return impl_->row_space ? impl_->row_space->project_on_range(basic) : basic;
}

}  // namespace tlsph

#include "tlsph/linear/factor_cost.hpp"

#include <algorithm>
#include <ctime>
#include <new>

#include "suitesparse.hpp"

namespace tlsph {
namespace {

/// A front of the systems that take long has about as many rows.
constexpr Index front = 800;
constexpr int repetitions = 3;

/// Of this process, so that others on the machine do not count.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

FactorCost factor_cost(const SparseMatrix& A) {
  require_square(A, "Cholesky (CHOLMOD)");
  FactorCost cost;
  cost.rows = A.rows();
  if (A.rows() == 0) return cost;
  SparseMatrix compressed;
  if (!A.isCompressed()) {
    compressed = A;
    compressed.makeCompressed();
  }
  cholmod_sparse view = sparse_view(A.isCompressed() ? A : compressed);
  CholmodState state;
  state.get()->final_ll = 1;
  cholmod_factor* factor = cholmod_analyze(&view, state.get());
  if (factor == nullptr) {
    const int status = state.get()->status;
    if (status == CHOLMOD_OUT_OF_MEMORY || status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
    throw_failure("Cholesky (CHOLMOD)", A, "the analysis failed");
  }
  cost.entries = state.get()->lnz;
  cost.flops = state.get()->fl;
  const auto stored = static_cast<double>(factor->xsize);
  const double values = factor->is_super != 0 ? std::max(stored, cost.entries) : cost.entries;
  // The factor; the update of the largest supernode; the matrix in the order of elimination, twice.
  cost.bytes = 8.0 * (values + static_cast<double>(factor->maxcsize)) +
               4.0 * static_cast<double>(factor->ssize) + 24.0 * static_cast<double>(view.nzmax);
  if (factor->is_super == 0) cost.bytes += 4.0 * cost.entries;
  cholmod_free_factor(&factor, state.get());
  return cost;
}

double factorisation_speed() {
  SparseMatrix dense(front, front);
  dense.reserve(Eigen::VectorXi::LinSpaced(front, 1, static_cast<int>(front)));
  for (int row = 0; row < front; ++row)
    for (int col = 0; col <= row; ++col)
      dense.insert(row, col) = row == col ? static_cast<double>(front) : 0.5;
  dense.makeCompressed();
  Cholesky factor(dense);  // the first one finds its memory
  const double start = processor_seconds();
  for (int k = 0; k < repetitions; ++k) factor.refactorize(dense);
  const double seconds = processor_seconds() - start;
  const auto n = static_cast<double>(front);
  return repetitions * n * n * n / 3 / seconds;
}

}  // namespace tlsph

#include "tlsph/operators/products.hpp"

#include <cassert>

namespace tlsph {
namespace {

/// Below this many rows a second thread costs more than it brings.
constexpr Index parallel_rows = 2000;

/// y = alpha y + beta A x for alpha, beta known at compile time.
template <int D, int Alpha, int Beta>
void combine(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  assert(A.isCompressed() && A.cols() == x.rows() && A.rows() == y.rows());
  const int* start = A.outerIndexPtr();
  const int* column = A.innerIndexPtr();
  const double* value = A.valuePtr();
  const double* in = x.data();
  double* out = y.data();
#pragma omp parallel for schedule(static) if (A.rows() >= parallel_rows)
  for (Index p = 0; p < A.rows(); ++p) {
    double sum[D] = {};
    for (int k = start[p]; k < start[p + 1]; ++k)
      for (int i = 0; i < D; ++i) sum[i] += value[k] * in[static_cast<Index>(column[k]) * D + i];
    for (int i = 0; i < D; ++i) {
      double& slot = out[p * D + i];
      slot = (Alpha == 0 ? 0.0 : slot) + Beta * sum[i];
    }
  }
}

}  // namespace

template <int D>
void multiply(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  combine<D, 0, 1>(A, x, y);
}

template <int D>
void subtract_product(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  combine<D, 1, -1>(A, x, y);
}

template void multiply<1>(const SparseMatrix&, const VectorField<1>&, VectorField<1>&);
template void multiply<2>(const SparseMatrix&, const VectorField<2>&, VectorField<2>&);
template void subtract_product<1>(const SparseMatrix&, const VectorField<1>&, VectorField<1>&);
template void subtract_product<2>(const SparseMatrix&, const VectorField<2>&, VectorField<2>&);

}  // namespace tlsph

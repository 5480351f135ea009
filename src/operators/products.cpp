#include "tlsph/operators/products.hpp"

#include <cassert>

#include "tlsph/core/parallel.hpp"

namespace tlsph {
namespace {

/// y = alpha y + beta A x for alpha, beta known at compile time.
template <int D, int Alpha, int Beta>
void combine(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  assert(A.isCompressed() && A.cols() == x.rows() && A.rows() == y.rows());
  const int* start = A.outerIndexPtr();
  const int* column = A.innerIndexPtr();
  const double* value = A.valuePtr();
  const double* in = x.data();
  double* out = y.data();
  for_rows(A.rows(), [=](Index p) {
    double sum[D] = {};
    for (int k = start[p]; k < start[p + 1]; ++k)
      for (int i = 0; i < D; ++i) sum[i] += value[k] * in[static_cast<Index>(column[k]) * D + i];
    for (int i = 0; i < D; ++i) {
      double& slot = out[p * D + i];
      slot = (Alpha == 0 ? 0.0 : slot) + Beta * sum[i];
    }
  });
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

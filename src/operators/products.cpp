#include "tlsph/operators/products.hpp"

#include <cassert>

#include "tlsph/core/parallel.hpp"

namespace tlsph {
namespace {

/// y_p = alpha y_p + beta Σ_q A_pq (x_q − base x_p) for alpha, beta and base known at compile time.
template <int D, int Alpha, int Beta, int Base>
void combine(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  assert(A.isCompressed() && A.cols() == x.rows() && A.rows() == y.rows());
  const int* start = A.outerIndexPtr();
  const int* column = A.innerIndexPtr();
  const double* value = A.valuePtr();
  const double* in = x.data();
  double* out = y.data();
  for_rows(A.rows(), [=](Index p) {
    double sum[D] = {};
    for (int k = start[p]; k < start[p + 1]; ++k) {
      const double* other = in + static_cast<Index>(column[k]) * D;
      for (int i = 0; i < D; ++i)
        sum[i] += value[k] * (Base == 0 ? other[i] : other[i] - in[p * D + i]);
    }
    for (int i = 0; i < D; ++i) {
      double& slot = out[p * D + i];
      slot = (Alpha == 0 ? 0.0 : slot) + Beta * sum[i];
    }
  });
}

}  // namespace

template <int D>
void multiply(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  combine<D, 0, 1, 0>(A, x, y);
}

template <int D>
void multiply_differences(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  combine<D, 0, 1, 1>(A, x, y);
}

template <int D>
void subtract_differences(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y) {
  combine<D, 1, -1, 1>(A, x, y);
}

template <int D>
Vector<D> differences_row(const SparseMatrix& A, Index p, const VectorField<D>& x) {
  Vector<D> sum = Vector<D>::Zero();
  for (SparseMatrix::InnerIterator it(A, p); it; ++it)
    for (int i = 0; i < D; ++i) sum[i] += it.value() * (x(it.col(), i) - x(p, i));
  return sum;
}

#define TLSPH_INSTANTIATE(D)                                                                \
  template Vector<D> differences_row<D>(const SparseMatrix&, Index, const VectorField<D>&); \
  template void multiply<D>(const SparseMatrix&, const VectorField<D>&, VectorField<D>&);   \
  template void multiply_differences<D>(const SparseMatrix&, const VectorField<D>&,         \
                                        VectorField<D>&);                                   \
  template void subtract_differences<D>(const SparseMatrix&, const VectorField<D>&,         \
                                        VectorField<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph

#pragma once
/// \file
/// Products of a plain sparse matrix with every component of a vector field, in place and without
/// temporaries; rows are shared among threads, so the result does not depend on their number.

#include "tlsph/core/types.hpp"

namespace tlsph {

/// y = A x, A N×N, x and y N×d.
template <int D>
void multiply(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y);

/// y_p = Σ_q A_pq (x_q − x_p): A x where the rows of A sum to zero, as those of stabilisers do,
/// with rounding errors of the size of the differences. A body that has travelled far keeps its
/// momentum.
template <int D>
void multiply_differences(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y);

/// y −= the same.
template <int D>
void subtract_differences(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y);

/// One row of it, y_p, summed in the same order.
template <int D>
[[nodiscard]] Vector<D> differences_row(const SparseMatrix& A, Index p, const VectorField<D>& x);

}  // namespace tlsph

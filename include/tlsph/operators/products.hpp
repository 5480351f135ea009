#pragma once
/// \file
/// Products of a plain sparse matrix with every component of a vector field, in place and without
/// temporaries; rows are shared among threads, so the result does not depend on their number.

#include "tlsph/core/types.hpp"

namespace tlsph {

/// y = A x, A N×N, x and y N×d.
template <int D>
void multiply(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y);

/// y −= A x.
template <int D>
void subtract_product(const SparseMatrix& A, const VectorField<D>& x, VectorField<D>& y);

}  // namespace tlsph

#pragma once
/// \file
/// What a Cholesky factorisation will cost, before it is made: from its symbolic analysis.

#include "tlsph/core/types.hpp"

namespace tlsph {

struct FactorCost {
  Index rows = 0;
  double entries = 0.0;  ///< of the factor
  double flops = 0.0;    ///< of a numerical factorisation
  double bytes = 0.0;    ///< of the factor, its indices and what making it takes beside it
};

/// The order and the symbolic analysis Cholesky would use for the matrix (its lower triangle), at a
/// small part of the cost; values are not looked at.
[[nodiscard]] FactorCost factor_cost(const SparseMatrix& A);

/// Floating point operations a second [1/s] that this machine reaches in factorisations: of a small
/// dense matrix, now, in less than a tenth of a second.
[[nodiscard]] double factorisation_speed();

}  // namespace tlsph

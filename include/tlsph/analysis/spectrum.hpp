#pragma once
/// \file
/// Whole spectra of small sparse operators, by dense linear algebra: n² memory, n³ time. The only
/// door to Armadillo. What only the extremes are needed of goes to linear/krylov.hpp.

#include <complex>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Rows or columns beyond which a dense spectrum is refused: 200 MB a copy, minutes.
inline constexpr Index largest_dense = 5000;

/// All eigenvalues of a square matrix, largest modulus first; conjugate pairs stand side by side.
/// An exactly symmetric matrix goes through the symmetric solver, its eigenvalues have no imaginary
/// part. InputError if the matrix is not square, not finite or larger than `largest_dense`;
/// NumericalError if the iteration does not converge.
[[nodiscard]] std::vector<std::complex<double>> eigenvalues(const SparseMatrix& matrix);

/// Eigenvalues of least modulus, ascending in it, with their unit eigenvectors.
struct Modes {
  std::vector<double> values;
  Eigen::MatrixXd vectors;  ///< a column each
};

/// The `count` of them (at most the rows) of a symmetric matrix. InputError if it is not exactly
/// symmetric; other errors as above.
[[nodiscard]] Modes lowest_modes(const SparseMatrix& matrix, Index count);

/// All min(rows, columns) singular values, largest first. Errors as above.
[[nodiscard]] std::vector<double> singular_values(const SparseMatrix& matrix);

}  // namespace tlsph

#pragma once
/// \file
/// Whole spectra of small sparse operators, by dense linear algebra: n² memory, n³ time; and how
/// fast motions with such a spectrum grow. The only door to Armadillo. Where only the extremes are
/// needed, linear/krylov.hpp finds them.

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

/// Largest Re(s) [1/s] of the free motions e^{st}, s² = −ω²: zero where all ω² are real and
/// positive, up to the square root of round-off.
[[nodiscard]] double growth_rate(const std::vector<std::complex<double>>& squared_frequencies);

/// ln |z| of the fastest motion zⁿ under the central difference of step `dt` [s], where
/// z − 2 + 1/z = −ω² dt².
[[nodiscard]] double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies,
                                     double dt);

}  // namespace tlsph

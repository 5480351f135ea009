#include "tlsph/analysis/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <armadillo>
#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

arma::mat dense(const SparseMatrix& matrix) {
  if (std::max(matrix.rows(), matrix.cols()) > largest_dense)
    throw InputError(
        fmt::format("a dense spectrum of {} x {} entries is too large; at most {} rows",
                    matrix.rows(), matrix.cols(), largest_dense));
  arma::mat result(static_cast<arma::uword>(matrix.rows()), static_cast<arma::uword>(matrix.cols()),
                   arma::fill::zeros);
  for (Index row = 0; row < matrix.outerSize(); ++row)
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
      result(static_cast<arma::uword>(entry.row()), static_cast<arma::uword>(entry.col())) +=
          entry.value();
  if (!result.is_finite()) throw InputError("the matrix holds values that are not finite");
  return result;
}

void require(bool converged) {
  if (!converged) throw NumericalError("the dense spectrum did not converge", 0.0, -1);
}

bool symmetric(const arma::mat& A) {
  for (arma::uword j = 0; j < A.n_cols; ++j)
    for (arma::uword i = 0; i < j; ++i)
      if (A(i, j) != A(j, i)) return false;
  return true;
}

/// Modulus down; equal moduli by real, then imaginary part, which keeps conjugates side by side.
bool before(const std::complex<double>& a, const std::complex<double>& b) {
  if (std::abs(a) != std::abs(b)) return std::abs(a) > std::abs(b);
  if (a.real() != b.real()) return a.real() > b.real();
  return a.imag() > b.imag();
}

}  // namespace

std::vector<std::complex<double>> eigenvalues(const SparseMatrix& matrix) {
  if (matrix.rows() != matrix.cols())
    throw InputError(
        fmt::format("eigenvalues need a square matrix, not {} x {}", matrix.rows(), matrix.cols()));
  std::vector<std::complex<double>> result;
  if (matrix.rows() == 0) return result;
  const arma::mat A = dense(matrix);
  if (symmetric(A)) {
    arma::vec values;
    require(arma::eig_sym(values, A));
    result.assign(values.begin(), values.end());
  } else {
    arma::cx_vec values;
    require(arma::eig_gen(values, A));
    result.assign(values.begin(), values.end());
  }
  std::ranges::sort(result, before);
  return result;
}

Modes lowest_modes(const SparseMatrix& matrix, Index count) {
  const arma::mat A = dense(matrix);
  if (matrix.rows() != matrix.cols() || !symmetric(A))
    throw InputError("modes are those of a symmetric matrix");
  if (matrix.rows() == 0) return {};
  arma::vec values;
  arma::mat vectors;
  require(arma::eig_sym(values, vectors, A));
  const arma::uvec order = arma::sort_index(arma::abs(values));
  const Index wanted = std::min(count, matrix.rows());
  Modes modes{{}, Eigen::MatrixXd(matrix.rows(), wanted)};
  for (Index k = 0; k < wanted; ++k) {
    const arma::uword from = order(static_cast<arma::uword>(k));
    modes.values.push_back(values(from));
    modes.vectors.col(k) = Eigen::Map<const Eigen::VectorXd>(vectors.colptr(from), matrix.rows());
  }
  return modes;
}

std::vector<double> singular_values(const SparseMatrix& matrix) {
  if (matrix.rows() == 0 || matrix.cols() == 0) return {};
  arma::vec values;
  require(arma::svd(values, dense(matrix)));
  return {values.begin(), values.end()};
}

}  // namespace tlsph

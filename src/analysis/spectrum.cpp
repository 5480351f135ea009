#include "tlsph/analysis/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <armadillo>
#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

Eigen::MatrixXd dense(const SparseMatrix& matrix) {
  if (std::max(matrix.rows(), matrix.cols()) > largest_dense)
    throw InputError(
        fmt::format("a dense spectrum of {} x {} entries is too large; at most {} rows",
                    matrix.rows(), matrix.cols(), largest_dense));
  Eigen::MatrixXd result = matrix;
  if (!result.allFinite()) throw InputError("the matrix holds values that are not finite");
  return result;
}

/// The same memory, column by column in both libraries.
arma::mat shared(Eigen::MatrixXd& A) {
  return {A.data(), static_cast<arma::uword>(A.rows()), static_cast<arma::uword>(A.cols()), false,
          true};
}

void require(bool converged) {
  if (!converged) throw NumericalError("the dense spectrum did not converge", 0.0, -1);
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
  Eigen::MatrixXd A = dense(matrix);
  if (A == A.transpose()) {
    arma::vec values;
    require(arma::eig_sym(values, shared(A)));
    result.assign(values.begin(), values.end());
  } else {
    arma::cx_vec values;
    require(arma::eig_gen(values, shared(A)));
    result.assign(values.begin(), values.end());
  }
  std::ranges::sort(result, before);
  return result;
}

Modes lowest_modes(const SparseMatrix& matrix, Index count) {
  Eigen::MatrixXd A = dense(matrix);
  if (A.rows() != A.cols() || A != A.transpose())
    throw InputError("modes are those of a symmetric matrix");
  if (matrix.rows() == 0) return {};
  arma::vec values;
  arma::mat vectors;
  require(arma::eig_sym(values, vectors, shared(A)));
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

double growth_rate(const std::vector<std::complex<double>>& squared_frequencies) {
  double rate = 0.0;
  for (const std::complex<double>& square : squared_frequencies)
    rate = std::max(rate, std::abs(std::sqrt(-square).real()));
  return rate;
}

double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies, double dt) {
  double largest = 0.0;
  for (const std::complex<double>& square : squared_frequencies) {
    // The roots of z² − 2bz + 1 are inverse to each other: either sign will do.
    const std::complex<double> b = 1.0 - 0.5 * square * dt * dt;
    largest = std::max(largest, std::abs(std::log(std::abs(b + std::sqrt(b * b - 1.0)))));
  }
  return largest;
}

}  // namespace tlsph

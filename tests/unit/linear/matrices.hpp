#pragma once
/// \file
/// Small matrices with known properties.

#include <Eigen/Dense>
#include <random>

#include "tlsph/core/types.hpp"

namespace tlsph::test {

inline SparseMatrix sparse(const Eigen::MatrixXd& dense) {
  SparseMatrix A = dense.sparseView();
  A.makeCompressed();
  return A;
}

inline Eigen::MatrixXd random_matrix(Index rows, Index cols, unsigned seed) {
  std::mt19937_64 bits(seed);
  Eigen::MatrixXd A(rows, cols);
  for (double& entry : A.reshaped()) entry = static_cast<double>(bits() >> 11) * 0x1p-52 - 1.0;
  return A;
}

/// tridiag(−1, 2, −1): eigenvalues 4 sin²(kπ / 2(n+1)), k = 1…n.
inline SparseMatrix laplacian(Index n) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 2.0);
    if (i > 0) entries.emplace_back(i, i - 1, -1.0);
    if (i + 1 < n) entries.emplace_back(i, i + 1, -1.0);
  }
  SparseMatrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// 5-point Laplacian plus `shift` on an n×n grid; CHOLMOD is supernodal for n = 100.
inline SparseMatrix laplacian_2d(Index n, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const Index row = i * n + j;
      entries.emplace_back(row, row, 4.0 + shift);
      if (i > 0) entries.emplace_back(row, row - n, -1.0);
      if (j > 0) entries.emplace_back(row, row - 1, -1.0);
      if (j + 1 < n) entries.emplace_back(row, row + 1, -1.0);
      if (i + 1 < n) entries.emplace_back(row, row + n, -1.0);
    }
  }
  SparseMatrix A(n * n, n * n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

inline double relative_residual(const SparseMatrix& A, const Eigen::MatrixXd& x,
                                const Eigen::MatrixXd& b) {
  return (A * x - b).norm() / b.norm();
}

}  // namespace tlsph::test

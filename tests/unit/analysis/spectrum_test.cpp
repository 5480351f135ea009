#include "tlsph/analysis/spectrum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

SparseMatrix sparse(Index rows, Index cols, const Entries& entries) {
  SparseMatrix matrix(rows, cols);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// (n + 1) × n: differences of n values held at zero on both sides.
SparseMatrix differences(int n) {
  Entries entries;
  for (int k = 0; k < n; ++k) {
    entries.emplace_back(k, k, 1.0);
    entries.emplace_back(k + 1, k, -1.0);
  }
  return sparse(n + 1, n, entries);
}

/// Of the fixed chain: 2 sin(kπ/(2(n+1))), k = n, …, 1.
double chain_frequency(int n, int place) {
  return 2.0 * std::sin((n - place) * std::numbers::pi / (2.0 * (n + 1)));
}

TEST(Eigenvalues, OfASymmetricMatrixAreRealAndFall) {
  constexpr int n = 20;
  const SparseMatrix B = differences(n);

  const auto values = eigenvalues(SparseMatrix(B.transpose()) * B);

  ASSERT_EQ(values.size(), n);
  for (int k = 0; k < n; ++k) {
    const std::complex<double> value = values[static_cast<std::size_t>(k)];
    EXPECT_NEAR(value.real(), std::pow(chain_frequency(n, k), 2), 1e-13);
    EXPECT_EQ(value.imag(), 0.0);
  }
}

// The cyclic shift of n places has the n-th roots of one.
TEST(Eigenvalues, OfAGeneralMatrixAreComplex) {
  constexpr int n = 7;
  Entries entries;
  for (int k = 0; k < n; ++k) entries.emplace_back(k, (k + 1) % n, 2.0);

  const auto values = eigenvalues(sparse(n, n, entries));

  ASSERT_EQ(values.size(), n);
  for (int k = 0; k < n; ++k) {
    const std::complex<double> root = 2.0 * std::polar(1.0, 2.0 * std::numbers::pi * k / n);
    double nearest = 10.0;
    for (const std::complex<double>& value : values)
      nearest = std::min(nearest, std::abs(value - root));
    EXPECT_LT(nearest, 1e-13) << k;
  }
}

TEST(Eigenvalues, StandByModulusWithConjugatesTogether) {
  // Blocks [[1, −2], [2, 1]] (1 ± 2i), [[0, −3], [3, 0]] (±3i) and −1.
  const auto values = eigenvalues(sparse(5, 5,
                                         {{0, 0, 1.0},
                                          {0, 1, -2.0},
                                          {1, 0, 2.0},
                                          {1, 1, 1.0},
                                          {2, 3, -3.0},
                                          {3, 2, 3.0},
                                          {4, 4, -1.0}}));

  const std::vector<std::complex<double>> expected = {{0, 3}, {0, -3}, {1, 2}, {1, -2}, {-1, 0}};
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_LT(std::abs(values[k] - expected[k]), 1e-14) << k;
}

TEST(Spectrum, OfNothingIsEmpty) {
  EXPECT_TRUE(eigenvalues(SparseMatrix(0, 0)).empty());
}

TEST(Spectrum, IsRefusedWhereThereIsNone) {
  EXPECT_THROW((void)eigenvalues(SparseMatrix(2, 3)), InputError);
  EXPECT_THROW((void)eigenvalues(SparseMatrix(largest_dense + 1, largest_dense + 1)), InputError);
  EXPECT_THROW((void)eigenvalues(sparse(1, 1, {{0, 0, std::nan("")}})), InputError);
}

TEST(LowestModes, AreSmallInModulusAndSolveTheMatrix) {
  const SparseMatrix A =
      sparse(4, 4, {{0, 0, 5.0}, {1, 1, -0.5}, {2, 2, 2.0}, {2, 3, 1.0}, {3, 2, 1.0}, {3, 3, 2.0}});

  const Modes modes = lowest_modes(A, 2);

  ASSERT_EQ(modes.values.size(), 2U);
  EXPECT_NEAR(modes.values[0], -0.5, 1e-14);
  EXPECT_NEAR(modes.values[1], 1.0, 1e-14);
  for (int k = 0; k < 2; ++k) {
    const Eigen::VectorXd v = modes.vectors.col(k);
    EXPECT_NEAR(v.norm(), 1.0, 1e-14);
    EXPECT_LT((A * v - modes.values[static_cast<std::size_t>(k)] * v).norm(), 1e-13);
  }
}

TEST(LowestModes, RefuseAMatrixThatIsNotSymmetric) {
  EXPECT_THROW((void)lowest_modes(sparse(2, 2, {{0, 1, 1.0}}), 1), InputError);
}

}  // namespace
}  // namespace tlsph

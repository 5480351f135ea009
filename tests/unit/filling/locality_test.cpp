#include "tlsph/filling/cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tlsph {
namespace {

/// A grid of n×n nodes of the unit square, the last coordinate fastest.
VectorField<2> grid(Index n) {
  VectorField<2> X(n * n, 2);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      X.row(i * n + j) << static_cast<double>(i) / static_cast<double>(n - 1),
          static_cast<double>(j) / static_cast<double>(n - 1);
  return X;
}

template <int D>
VectorField<D> shuffled(const VectorField<D>& X, std::vector<int>& places) {
  places.resize(static_cast<std::size_t>(X.rows()));
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = static_cast<int>(k);
  std::mt19937 random(5);
  std::ranges::shuffle(places, random);
  VectorField<D> result(X.rows(), D);
  for (Index q = 0; q < X.rows(); ++q) result.row(q) = X.row(places[static_cast<std::size_t>(q)]);
  return result;
}

TEST(LocalOrder, LeavesALatticeAlone) {
  EXPECT_TRUE(local_order<2>(grid(20)).empty());
}

TEST(LocalOrder, LeavesALineAloneWhicheverWayItRuns) {
  VectorField<1> X(50, 1);
  for (Index q = 0; q < 50; ++q) X(q, 0) = 3.0 - 0.1 * static_cast<double>(q);

  EXPECT_TRUE(local_order<1>(X).empty());
}

TEST(LocalOrder, FindsTheRowsOfAShuffledLattice) {
  std::vector<int> places;
  const VectorField<2> X = shuffled<2>(grid(20), places);

  const std::vector<int> order = local_order<2>(X);

  ASSERT_EQ(order.size(), 400U);
  for (std::size_t k = 0; k < order.size(); ++k)
    ASSERT_EQ(places[static_cast<std::size_t>(order[k])], static_cast<int>(k));
}

TEST(LocalOrder, SortsAShuffledLine) {
  VectorField<1> line(60, 1);
  for (Index q = 0; q < 60; ++q) line(q, 0) = 0.1 * static_cast<double>(q);
  std::vector<int> places;

  const std::vector<int> order = local_order<1>(shuffled<1>(line, places));

  ASSERT_EQ(order.size(), 60U);
  for (std::size_t k = 0; k < order.size(); ++k)
    ASSERT_EQ(places[static_cast<std::size_t>(order[k])], static_cast<int>(k));
}

TEST(LocalOrder, HasNothingToSayOfOneNode) {
  EXPECT_TRUE(local_order<2>(VectorField<2>::Zero(1, 2)).empty());
}

}  // namespace
}  // namespace tlsph

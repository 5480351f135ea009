#include "tlsph/operators/row_storage.hpp"

#include <gtest/gtest.h>

namespace tlsph {
namespace {

/// Differences of neighbours, x_{k+1} − x_k over `spacing`, at rounded positions from `origin` on.
struct Differences {
  Neighbours pattern;
  std::vector<double> weights;

  Differences(Index rows, double origin, double spacing) {
    pattern.start = {0};
    for (Index r = 0; r < rows; ++r) {
      const double here = origin + spacing * static_cast<double>(r);
      const double next = origin + spacing * static_cast<double>(r + 1);
      for (const double sign : {-1.0, 1.0}) weights.push_back(sign / (next - here));
      pattern.column.push_back(static_cast<int>(r));
      pattern.column.push_back(static_cast<int>(r + 1));
      pattern.start.push_back(static_cast<Index>(pattern.column.size()));
    }
  }
};

TEST(RowStorage, StoresOneStencilForALattice) {
  const Differences of(1000, 0.0, 0.5);

  const RowStorage storage = share_rows(of.pattern, of.weights, 1);

  ASSERT_EQ(storage.stencils(), 1);
  ASSERT_EQ(storage.runs.size(), 1U);
  EXPECT_EQ(storage.runs[0].count, 1000);
  EXPECT_EQ(storage.offset, (std::vector<int>{0, 1}));
  EXPECT_EQ(storage.weight, (std::vector<double>{-2.0, 2.0}));
  EXPECT_EQ(storage.reach, (std::vector<int>{1}));
}

TEST(RowStorage, LeavesRowsThatShareNothing) {
  Differences of(100, 0.0, 0.5);
  for (std::size_t k = 0; k < of.weights.size(); ++k)
    of.weights[k] *= 1.0 + 1e-3 * static_cast<double>(k);

  const RowStorage storage = share_rows(of.pattern, of.weights, 1);
  const StorageReport told = report(storage, of.pattern);

  EXPECT_EQ(storage.stencils(), 0);
  EXPECT_EQ(told.general_rows, 100);
  EXPECT_EQ(told.stencil_rows, 0);
}

TEST(RowStorage, MakesARowAStencilFromFourUsesOn) {
  Differences of(100, 0.0, 0.5);
  for (std::size_t row : {10U, 30U, 50U}) of.weights[2 * row] = -1.0;

  EXPECT_EQ(report(share_rows(of.pattern, of.weights, 1), of.pattern).general_rows, 3);
  of.weights[2 * 70] = -1.0;
  EXPECT_EQ(report(share_rows(of.pattern, of.weights, 1), of.pattern).general_rows, 0);
}

/// Half a million particles in a row: weights differ by 1e-10 for the rounding of places alone.
TEST(RowStorage, SeesThroughTheRoundingOfFarPlaces) {
  const Index rows = 500'000;
  const double spacing = 1.0 / static_cast<double>(rows);
  Differences of(rows, 0.0, spacing);

  const double tolerance = shared_row_tolerance(1.0, spacing);
  const RowStorage storage = share_rows(of.pattern, of.weights, 1, tolerance);

  EXPECT_LT(tolerance, 1e-9);
  EXPECT_EQ(storage.stencils(), 1);
  EXPECT_EQ(storage.runs.size(), 1U);
  write_shared(storage, of.pattern, of.weights);
  for (std::size_t k = 0; k < of.weights.size(); k += 2) ASSERT_EQ(of.weights[k], of.weights[0]);
}

TEST(RowStorage, TakesNearPlacesAtTheirWord) {
  EXPECT_EQ(shared_row_tolerance(1.0, 1e-3), 1e-11);
  EXPECT_EQ(shared_row_tolerance(0.0, 1e-3), 1e-11);
}

TEST(AppendRuns, CutsRunsToTheRowsAndKeepsTheirColumns) {
  const std::vector<RowRun> runs = {{0, 10, 3, 0}, {10, 5, 0, no_stencil}, {15, 5, 20, 1}};
  std::vector<RowRun> cut(2);

  EXPECT_EQ(append_runs(runs, 4, 17, cut), 2);

  ASSERT_EQ(cut.size(), 5U);
  const auto expect = [&](std::size_t k, int first, int count, int column, int stencil) {
    EXPECT_EQ(cut[k].first, first);
    EXPECT_EQ(cut[k].count, count);
    EXPECT_EQ(cut[k].column, column);
    EXPECT_EQ(cut[k].stencil, stencil);
  };
  expect(2, 4, 6, 7, 0);
  expect(3, 10, 5, 0, no_stencil);
  expect(4, 15, 2, 20, 1);
}

TEST(SharedValues, BecomeTheFirstOfThem) {
  ScalarField values(5);
  values << 1.0, 1.0 + 1e-13, 2.0, 1.0 - 1e-13, 2.0 + 1e-3;

  const ScalarField shared = with_shared_values(values, 1e-11);

  EXPECT_EQ(shared[1], 1.0);
  EXPECT_EQ(shared[3], 1.0);
  EXPECT_EQ(shared[4], 2.0 + 1e-3);
}

TEST(RowStorage, HoldsAFurtherNumberBehindTheOthers) {
  const Differences of(10, 0.0, 0.5);
  const std::vector<double> further(of.weights.size(), 7.0);

  const RowStorage storage = share_rows(of.pattern, of.weights, 1, 0.0, further);

  EXPECT_EQ(storage.stride, 2);
  EXPECT_EQ(storage.weight, (std::vector<double>{-2.0, 7.0, 2.0, 7.0}));
}

TEST(RowStorage, TellsRowsApartByTheFurtherNumberAlone) {
  const Differences of(10, 0.0, 0.5);
  std::vector<double> further(of.weights.size(), 7.0);
  for (std::size_t row = 5; row < 10; ++row) further[2 * row + 1] = 8.0;

  const RowStorage storage = share_rows(of.pattern, of.weights, 1, 0.0, further);

  ASSERT_EQ(storage.runs.size(), 2U);
  EXPECT_EQ(storage.runs[1].first, 5);
  EXPECT_EQ(storage.weight, (std::vector<double>{-2.0, 7.0, 2.0, 7.0, -2.0, 7.0, 2.0, 8.0}));
}

}  // namespace
}  // namespace tlsph

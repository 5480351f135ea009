#pragma once
/// \file
/// Rows of a sparse operator, those that are equal up to a shift stored once.
///
/// On a lattice nearly all rows of G and D are the same few stencils, moved along. A *stencil* is a
/// list of column offsets with their weights; a *run* is a range of consecutive rows that share
/// one, each a column further than the row before:
///
///     row first + r:   Σ_k w_k x[column + r + offset_k],   0 ≤ r < count
///
/// so that a product reads no index and no weight for each row and is vectorised across rows. Rows
/// that share nothing stay as they are, in runs without a stencil. Found from the numbers alone,
/// for any cloud of particles.

#include <cstddef>
#include <span>
#include <vector>

#include "tlsph/operators/neighbours.hpp"
#include "tlsph/operators/row_run.hpp"

namespace tlsph {

/// What a user is told of it.
struct StorageReport {
  Index stencil_rows = 0;
  Index distinct_stencils = 0;
  Index general_rows = 0;
  double bytes = 0.0;  ///< that a product reads: stencils, runs and general rows
};

struct RowStorage {
  std::vector<RowRun> runs;  ///< ascending; together all rows, each once
  /// Entries of stencil s: [stencil_start[s], stencil_start[s+1]).
  std::vector<int> stencil_start;
  std::vector<int> offset;
  std::vector<double> weight;  ///< `stride` numbers an entry
  std::vector<int> reach;      ///< largest offset of each stencil
  int stride = 1;

  [[nodiscard]] int stencils() const { return static_cast<int>(stencil_start.size()) - 1; }
};

/// Rows whose relative columns are the same and whose weights differ by at most `tolerance` of the
/// largest in the row are one stencil, with the weights of the first of them; a stencil that serves
/// fewer than four rows is none. `weights` holds `stride` numbers an entry of the pattern;
/// `further`, where it is not empty, one more, which stencils hold behind those. O(entries): a row
/// is compared with a bounded number of stencils.
[[nodiscard]] RowStorage share_rows(const Neighbours& pattern, std::span<const double> weights,
                                    int stride, double tolerance = 0.0,
                                    std::span<const double> further = {});

/// Appends the runs of rows [first, last), cut to them; returns where they start in `to`.
Index append_runs(const std::vector<RowRun>& runs, Index first, Index last,
                  std::vector<RowRun>& to);

/// Gives every row of a run exactly the weights of its stencil, which makes rows that differ by the
/// rounding of their positions equal to the last bit.
void write_shared(const RowStorage& storage, const Neighbours& pattern, std::span<double> weights);

[[nodiscard]] StorageReport report(const RowStorage& storage, const Neighbours& pattern);

/// Values within a relative `tolerance` of an earlier one become that one, as far as a bounded
/// number of candidates shows: volumes of equal particles become equal to the last bit.
[[nodiscard]] ScalarField with_shared_values(ScalarField values, double tolerance);

/// How far weights of rows that mean the same may differ, relative to a row's largest: positions as
/// far out as `reach` are rounded to ε reach, which is so much of a `spacing`. 1e-11 up to 1e4
/// particles a side.
[[nodiscard]] double shared_row_tolerance(double reach, double spacing);

}  // namespace tlsph

#pragma once
/// \file
/// Which nodes lie within the support of which points, found once in the reference configuration.

#include <algorithm>
#include <span>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Indices first … last − 1, for a loop over them.
struct IndexRange {
  struct Iterator {
    Index index = 0;
    [[nodiscard]] Index operator*() const { return index; }
    Iterator& operator++() { return ++index, *this; }
    [[nodiscard]] bool operator==(const Iterator&) const = default;
  };
  Index first = 0, last = 0;
  [[nodiscard]] Iterator begin() const { return {first}; }
  [[nodiscard]] Iterator end() const { return {last}; }
};

/// Compressed lists: the neighbours of row s are `column[start[s]] … column[start[s+1]-1]`,
/// ascending.
struct Neighbours {
  std::vector<Index> start;
  std::vector<int> column;

  [[nodiscard]] Index rows() const { return static_cast<Index>(start.size()) - 1; }
  [[nodiscard]] Index size() const { return static_cast<Index>(column.size()); }
  /// The places of a row's entries in `column`.
  [[nodiscard]] IndexRange entries(Index row) const {
    return {start[static_cast<std::size_t>(row)], start[static_cast<std::size_t>(row) + 1]};
  }
  [[nodiscard]] int column_at(Index entry) const { return column[static_cast<std::size_t>(entry)]; }
  [[nodiscard]] std::span<const int> of(Index row) const {
    const auto s = static_cast<std::size_t>(row);
    return {column.data() + start[s], column.data() + start[s + 1]};
  }
};

/// Nodes (rows of `nodes`, N×d) nearer than `radius` [m] to each row of `points` (M×d). Nodes on
/// the rim, where every kernel is zero, do not count (tolerance 1e-9 of the radius). O(M log N).
template <int D>
[[nodiscard]] Neighbours find_neighbours(const VectorField<D>& points, const VectorField<D>& nodes,
                                         double radius);

/// The entries of a pattern by columns, and where each of them is in the pattern.
struct ByColumns {
  Neighbours rows;
  std::vector<Index> entry;
};
[[nodiscard]] ByColumns by_columns(const Neighbours& pattern, Index columns);

/// The matrix of a pattern with value(k) at its entry k.
template <class Value>
[[nodiscard]] SparseMatrix matrix_of(const Neighbours& pattern, Index columns, const Value& value) {
  SparseMatrix result(pattern.rows(), columns);
  result.resizeNonZeros(pattern.size());
  std::ranges::transform(pattern.start, result.outerIndexPtr(),
                         [](Index start) { return static_cast<int>(start); });
  std::ranges::copy(pattern.column, result.innerIndexPtr());
  for (Index k = 0; k < pattern.size(); ++k) result.valuePtr()[k] = value(k);
  return result;
}

}  // namespace tlsph

#pragma once
/// \file
/// Which nodes lie within the support of which points, found once in the reference configuration.

#include <span>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Compressed lists: the neighbours of row s are `column[start[s]] … column[start[s+1]-1]`,
/// ascending.
struct Neighbours {
  std::vector<Index> start;
  std::vector<int> column;

  [[nodiscard]] Index rows() const { return static_cast<Index>(start.size()) - 1; }
  [[nodiscard]] Index size() const { return static_cast<Index>(column.size()); }
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

}  // namespace tlsph

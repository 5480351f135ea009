#pragma once
/// \file
/// Triangles between given edges, and pairs of them as quadrilaterals, for
/// filling/block_fill.cpp.

#include <array>
#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// The triangles on the left of closed chains of directed edges that do not cross: Delaunay, with
/// the edges that are missing in it inserted (Anglada 1997). `failed` is −1, or a node at which an
/// edge meets another or a triangle has no area.
struct ConstrainedTriangles {
  std::vector<Triangle> triangles;
  int failed = -1;
};
[[nodiscard]] ConstrainedTriangles triangles_between(const VectorField<2>& X,
                                                     const std::vector<std::array<int, 2>>& edges);

/// Joins neighbouring triangles to convex quadrilaterals, the best shaped first; what is left over
/// stays in `triangles`.
[[nodiscard]] std::vector<Cell<2>> paired(const VectorField<2>& X,
                                          std::vector<Triangle>& triangles);

}  // namespace tlsph

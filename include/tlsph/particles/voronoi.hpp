#pragma once
/// \file
/// Node volumes of scattered nodes: what of the body lies nearer to a node than to any other.

#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Area [m²] of the Voronoi cell of each node (N×2 positions `X`) within the polygon that the faces
/// enclose, which need be neither convex nor free of holes: Σ V is its area. The cell of a node is
/// a box around the body cut by the bisectors with its Delaunay neighbours (geometry/polygon.hpp);
/// its overlap with the body is the sum of its overlaps with the boundary loops, holes, which run
/// clockwise, counting negative.
[[nodiscard]] ScalarField voronoi_volumes(const VectorField<2>& X,
                                          const std::vector<Face<2>>& faces);

}  // namespace tlsph

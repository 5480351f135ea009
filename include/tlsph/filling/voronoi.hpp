#pragma once
/// \file
/// Node volumes of scattered nodes: what of the body lies nearer to a node than to any other.

#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Area [m²] of the Voronoi cell of each node (N×2 positions `X`) within the polygon that the faces
/// enclose, which need be neither convex nor free of holes: Σ V is its area. A cell is what the
/// bisectors with the Delaunay neighbours leave (geometry/polygon.hpp) of the loops of the
/// boundary, of which holes, running clockwise, count negative; well inside the body, of a box.
[[nodiscard]] ScalarField voronoi_volumes(const VectorField<2>& X,
                                          const std::vector<Face<2>>& faces);

}  // namespace tlsph

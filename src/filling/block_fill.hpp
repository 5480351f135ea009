#pragma once
/// \file
/// Any outline filled with quadrilaterals, for filling/fitted.cpp.
///
/// The body is first filled with blocks two spacings wide: squares of a lattice away from the
/// outline, triangles and quadrilaterals between them and the outline (constrained Delaunay
/// triangles, joined in pairs where that gives a good shape). Then every block is cut at the
/// middles of its edges, a quadrilateral into four cells and a triangle into three: whatever the
/// blocks are, all cells are convex quadrilaterals and meet edge to edge. Last, nodes near the
/// outline move to where the worst cells are best.

#include "quad_mesh.hpp"
#include "tlsph/geometry/shape.hpp"

namespace tlsph {

struct BlockFill {
  QuadMesh mesh;
  Vector<2> spacings = Vector<2>::Zero();  ///< mean distance of lattice lines per direction [m]
  double quality = 0.0;                    ///< least `cell_quality` for the spacing
  Vector<2> worst = Vector<2>::Zero();     ///< where that is
};

/// Cells about `spacing` [m] wide; quality ≤ 0 where blocks cannot be found.
[[nodiscard]] BlockFill fill_with_blocks(const Shape<2>& shape, double spacing);

}  // namespace tlsph

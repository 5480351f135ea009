#pragma once
/// \file
/// Quadrilaterals under construction, and any outline filled with them, for filling/fitted.cpp.

#include <array>
#include <functional>
#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {

struct QuadMesh {
  VectorField<2> X;
  std::vector<Cell<2>> cells;
};

/// Edges with a cell on one side only, from → to with the cell on the left, in the order of the
/// cells.
[[nodiscard]] std::vector<DirectedEdge> free_edges(const std::vector<Cell<2>>& cells);

/// Drops unused nodes and numbers nodes and cells afresh: columns of width `spacing` from `origin`,
/// y rising within each.
[[nodiscard]] QuadMesh renumbered(const QuadMesh& mesh, double origin, double spacing);

/// Counts `ring`, the number of edges from each node to the next one where it is 0, along the edges
/// of the cells, up to `rounds`.
void count_rings(const std::vector<Cell<2>>& cells, int rounds, std::vector<int>& ring);

/// What confines a node while the mesh is smoothed.
enum class Freedom { none, inner, along_x, along_y, on_curve };

/// Moves nodes to the mean of their neighbours (of those on the same curve or line, for confined
/// nodes), `rounds` times, then through `back` for nodes on the curve, as long as the least corner
/// Jacobian around a node does not fall, or stays above `enough` [m²].
void smooth(QuadMesh& mesh, const std::vector<Freedom>& freedom, int rounds, double enough,
            const std::function<Vector<2>(const Vector<2>&)>& back);

/// Least of J/max(|e||f|, size²) over the corners, J = e×f the cross product of the edges that meet
/// there: the sine of the corner for edges as long as `size` [m], less for shorter ones; 1 for a
/// rectangle no smaller than the size. Positive exactly for strictly convex cells.
[[nodiscard]] double cell_quality(const VectorField<2>& X, const Cell<2>& cell, double size);

/// Where a node may go while cells are improved: the closest allowed point.
using Track = std::function<Vector<2>(const Vector<2>&)>;

/// Moves nodes that have a track so that Σ exp(−`steepness` quality) over the cells around each
/// falls: the worst cells gain most (a smooth form of max min, cf. Freitag and Ollivier-Gooch
/// 1997). Nodes whose cells are all better than `enough` stay.
void improve(QuadMesh& mesh, const std::vector<Track>& tracks, int rounds, double size,
             double enough);

/// The triangles on the left of closed chains of directed edges that do not cross: Delaunay, with
/// the edges that are missing in it inserted (Anglada 1997). `failed` is −1, or a node at which an
/// edge meets another or a triangle has no area.
struct ConstrainedTriangles {
  std::vector<Triangle> triangles;
  int failed = -1;
};
[[nodiscard]] ConstrainedTriangles triangles_between(const VectorField<2>& X,
                                                     const std::vector<DirectedEdge>& edges);

/// Joins neighbouring triangles to convex quadrilaterals, the best shaped first; what is left over
/// stays in `triangles`.
[[nodiscard]] std::vector<Cell<2>> paired(const VectorField<2>& X,
                                          std::vector<Triangle>& triangles);

struct BlockFill {
  QuadMesh mesh;
  double quality = 0.0;                 ///< least `cell_quality` for the spacing
  Vector<2> worst = Vector<2>::Zero();  ///< where that is
};

/// The body is first filled with blocks two spacings wide: squares of a lattice away from the
/// outline, triangles and quadrilaterals between them and the outline (constrained Delaunay
/// triangles, joined in pairs where that gives a good shape). Then every block is cut at the
/// middles of its edges, a quadrilateral into four cells and a triangle into three: whatever the
/// blocks are, all cells are convex quadrilaterals and meet edge to edge. Last, nodes near the
/// outline move to where the worst cells are best.
///
/// Cells are about `spacing` [m] wide; quality ≤ 0 where blocks cannot be found.
[[nodiscard]] BlockFill fill_with_blocks(const Shape<2>& shape, double spacing);

}  // namespace tlsph

#pragma once
/// \file
/// Quadrilaterals under construction, for filling/fitted.cpp.

#include <array>
#include <functional>
#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

struct QuadMesh {
  VectorField<2> X;
  std::vector<Cell<2>> cells;
};

using DirectedEdge = std::array<int, 2>;

/// Edges with a cell on one side only, from → to with the cell on the left, in the order of the
/// cells.
[[nodiscard]] std::vector<DirectedEdge> free_edges(const std::vector<Cell<2>>& cells);

/// Drops unused nodes and numbers nodes and cells afresh: columns of width `spacing` from `origin`,
/// y rising within each.
[[nodiscard]] QuadMesh renumbered(const QuadMesh& mesh, double origin, double spacing);

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

}  // namespace tlsph

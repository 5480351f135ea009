#pragma once
/// \file
/// Delaunay triangles of scattered nodes, and the part of them that fills a body.
///
/// The triangles are the dual of the Voronoi diagram that Boost.Polygon sweeps out (Fortune 1987,
/// with exact predicates on integers). Of the libraries at hand it is the one that cannot be led
/// astray by rounding, and hexagonal and square lattices, whose nodes lie on common circles, are
/// where rounding bites; Qhull merges or joggles there, CGAL's triangulations are GPL. Its price is
/// a grid of 2³⁰ steps across the cloud, on which nodes are placed for the topology alone: every
/// length, area and volume is computed from the nodes as they are.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// All triangles of the convex hull of the nodes `X` (N×2 [m]), counter-clockwise; of nodes on one
/// circle (a square of a lattice) some triangulation; nodes in a line along the hull may leave a
/// triangle that is flat to rounding there. Nodes closer than 1e-9 of the cloud's size
/// are taken for one.
[[nodiscard]] std::vector<Triangle> delaunay(const VectorField<2>& X);

/// An edge from one node to another with something on its left.
using DirectedEdge = std::array<int, 2>;

/// The part of a triangulation that closed chains of edges enclose.
struct EnclosedTriangles {
  std::vector<Triangle> triangles;
  std::vector<DirectedEdge> missing;  ///< edges of the chains that have no triangle on their left
  int open = -1;                      ///< a node where the chains leave a gap, −1: nowhere
};

/// The triangles of `all` on the left of the chains, in their order.
[[nodiscard]] EnclosedTriangles enclosed_by(const std::vector<DirectedEdge>& chains,
                                            const std::vector<Triangle>& all);

/// Where a node came from, for complaints about it.
using NodePlaces = std::function<Place(Index)>;

/// A position as messages write it, (x) or (x, y).
[[nodiscard]] std::string position_text(const Eigen::Ref<const Eigen::VectorXd>& x);

/// The Delaunay triangles on the inner side of the boundary faces (body on their left): their areas
/// sum to what the faces enclose. InputError, at the place of a node, where a face is no edge of
/// the triangulation (nodes of the body stand too close to it for its length), or a triangle has no
/// area, or a node is in no triangle.
[[nodiscard]] std::vector<Triangle> triangulate(const VectorField<2>& X,
                                                const std::vector<Face<2>>& faces,
                                                const NodePlaces& places);

/// Area [m²], positive for counter-clockwise nodes.
[[nodiscard]] double triangle_area(const VectorField<2>& X, const Triangle& triangle);

/// Mean of the corners.
[[nodiscard]] Vector<2> triangle_centre(const VectorField<2>& X, const Triangle& triangle);

/// An edge a → b between triangles, with the nodes that face it on its left and, unless it is part
/// of the boundary, on its right (else −1).
struct TriangleEdge {
  int a = 0, b = 0;
  int left = 0, right = -1;
};

/// Every edge once: in the order of the triangles that first have it on their left.
[[nodiscard]] std::vector<TriangleEdge> edges_of(const std::vector<Triangle>& triangles);

}  // namespace tlsph

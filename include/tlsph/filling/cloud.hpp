#pragma once
/// \file
/// Bodies filled with scattered nodes: hexagonal lattices and points of the user's own.
///
/// Some of the nodes lie on the boundary of the shape, its corners among them. Faces join those
/// that follow one another along the outline (geometry/outline.hpp), Delaunay triangles fill what
/// the faces enclose (particles/delaunay.hpp), volumes are Voronoi cells clipped to it
/// (`voronoi_volumes`). In 1D the cells are the intervals between neighbours, and half of each
/// goes to either end. Hence Σ V is what the faces enclose, Σ_q B_q = 0 and Σ_q B^a_q X^b_q = |Ω|
/// δ_ab, as on a lattice.

#include <string>
#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {

/// Nodes nearer to the boundary than this share of the spacing are on it, and are put there.
inline constexpr double boundary_tolerance = 1e-3;

/// Particles at the nodes `X` (N×d [m], their order stays) in that shape; `spacing` [m] is what
/// supports are measured in, 0: that of a square lattice with as many. Patches are those of a
/// lattice. InputError, at the place of the node, for one outside the shape, two in one place
/// (nearer than `boundary_tolerance`), a corner of the shape or an end of the interval without a
/// node, too few nodes on the boundary, and where the nodes cannot be triangulated.
template <int D>
[[nodiscard]] Particles<D> make_cloud(VectorField<D> X, const Shape<D>& shape, double spacing,
                                      const NodePlaces& places);

/// The same particles with volumes `V` (N, [m^d]) of the user's own. InputError unless they are
/// positive and their sum is within 1 % of the body's size.
template <int D>
[[nodiscard]] Particles<D> with_volumes(Particles<D> particles, ScalarField V,
                                        const Shape<D>& shape, const NodePlaces& places);

/// Faces between nodes that follow one another along the outline, loop by loop, labelled by what
/// they border. Nodes within `tolerance` [m] of the outline are moved onto it, those within it of a
/// corner into that corner. InputError, at the place of a node (of the first one for what no node
/// is to blame for), for a node outside the shape, a corner without a node, or a loop with fewer
/// than three.
[[nodiscard]] std::vector<LabelledFace<2>> outline_faces(VectorField<2>& X, const Shape<2>& shape,
                                                         double tolerance,
                                                         const NodePlaces& places);

/// Area [m²] of the Voronoi cell of each node (N×2 positions `X`) within the polygon that the faces
/// enclose, which need be neither convex nor free of holes: Σ V is its area. A cell is what the
/// bisectors with the Delaunay neighbours leave (geometry/polygon.hpp) of the loops of the
/// boundary, of which holes, running clockwise, count negative; well inside the body, of a box.
[[nodiscard]] ScalarField voronoi_volumes(const VectorField<2>& X,
                                          const std::vector<Face<2>>& faces);

/// An order in which nodes `X` (N×d [m]) follow one another along strips as wide as their mean
/// distance, like the rows of a lattice (last coordinate fastest), so that a step passes over the
/// body through a window of a few rows. Result k is the node to come k-th. Empty if the order there
/// is does as well: three nodes in four are within three mean distances of the one before.
template <int D>
[[nodiscard]] std::vector<int> local_order(const VectorField<D>& X);

/// The nodes in the order of their places, first coordinate first.
template <int D>
[[nodiscard]] std::vector<int> by_place(const VectorField<D>& X);

}  // namespace tlsph

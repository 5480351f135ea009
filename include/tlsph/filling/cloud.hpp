#pragma once
/// \file
/// Bodies filled with scattered nodes: hexagonal lattices and points of the user's own.
///
/// Some of the nodes lie on the boundary of the shape, its corners among them. Faces join those
/// that follow one another along the outline (geometry/outline.hpp), Delaunay triangles fill what
/// the faces enclose (particles/delaunay.hpp), volumes are Voronoi cells clipped to it
/// (filling/voronoi.hpp). In 1D the cells are the intervals between neighbours, and half of each
/// goes to either end. Hence Σ V is what the faces enclose, Σ_q B_q = 0 and Σ_q B^a_q X^b_q = |Ω|
/// δ_ab, as on a lattice.

#include <string>
#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Nodes nearer to the boundary than this share of the spacing are on it, and are put there.
inline constexpr double boundary_tolerance = 1e-3;

/// Distance [m] of neighbours in the square lattice that fills the shape with as many nodes, of
/// which so many lie on the boundary.
template <int D>
[[nodiscard]] double cloud_spacing(const Shape<D>& shape, Index nodes, Index on_boundary);

/// Particles at the nodes `X` (N×d [m], their order stays) in that shape; `spacing` [m] is what
/// supports are measured in, 0: `cloud_spacing`. Patches are those of a lattice. InputError, at the
/// place of the node, for one outside the shape, two in one place (nearer than
/// `boundary_tolerance`), a corner of the shape or an end of the interval without a node, too few
/// nodes on the boundary, and where the nodes cannot be triangulated.
template <int D>
[[nodiscard]] Particles<D> make_cloud(VectorField<D> X, const Shape<D>& shape, double spacing,
                                      const NodePlaces& places);

/// The same particles with volumes `V` (N, [m^d]) of the user's own. InputError unless they are
/// positive and their sum is within 1 % of the body's size.
template <int D>
[[nodiscard]] Particles<D> with_volumes(Particles<D> particles, ScalarField V,
                                        const Shape<D>& shape, const NodePlaces& places);

/// The same particles with a patch of those nodes and of the boundary faces between them.
/// InputError if the name is taken.
template <int D>
[[nodiscard]] Particles<D> with_named_nodes(Particles<D> particles, const std::string& name,
                                            std::vector<int> nodes, const Place& place);

}  // namespace tlsph

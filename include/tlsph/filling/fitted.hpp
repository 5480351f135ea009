#pragma once
/// \file
/// Lattices that follow a curved or slanted boundary instead of approaching it in stairs.
///
/// Stairs cannot simply be pulled onto the curve: the outer corner of a step would become an angle
/// of 180°. Instead the lattice keeps a core of cells at some distance from the curve, every front
/// node of the core gets a partner on the curve, and a layer of quadrilaterals joins the two
/// (grid-based meshing, Schneiders 1996). A few rounds of smoothing then share the distortion out
/// among the nodes near the curve; a move is made only if it does not worsen the worst corner
/// around it.
///
/// Where no such layer fits (an edge along the lattice that meets a slanted one at a wide angle, a
/// part few spacings wide) the body is filled with blocks two spacings wide, squares of a lattice
/// away from the boundary and triangles or quadrilaterals next to it, each cut into cells.

#include "tlsph/core/error.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// The lattice (on-boundary placement, no jitter) of that shape with its stairs replaced by cells
/// whose outer nodes lie on the true boundary, corners included. Edges of the shape along lattice
/// lines stay as they are; a shape with no other edges comes back unchanged. Nodes are numbered
/// afresh, row by row with y fastest as nearly as their places allow; patches are those of a
/// lattice; Σ V differs from the area of the shape by the segments between chords and arcs only.
///
/// In every cell each corner has a Jacobian (cross product of the edges that meet there) of at
/// least 0.1 Δ² and a sine of at least 0.1; no edge is longer than 4 Δ. Simple polygons with angles
/// from 20° to 340°, edges of at least 2 Δ and no two edges without a common corner nearer than 2 Δ
/// are always filled. InputError, at `place`, for other shapes where that is impossible (a spacing
/// too coarse for the curvature or for the gap between two boundaries), or if there are no cells.
[[nodiscard]] Particles<2> fitted(const Particles<2>& lattice, const Shape<2>& shape,
                                  const Place& place = {});

/// The same from the shape. A shape cut from a box needs a spacing [m] that divides the box
/// (`make_lattice`); for others that Δ need not divide, the lattice is stretched to the straight
/// edges along its axes.
[[nodiscard]] Particles<2> fitted(const Shape<2>& shape, double spacing, const Place& place = {});

}  // namespace tlsph

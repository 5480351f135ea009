#pragma once
/// \file
/// Hexagonal (triangular) lattices: every inner node has six neighbours, all as far away.

#include "tlsph/core/error.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Rows along x, Δ apart in them, every other one shifted by Δ/2 and √3/2 Δ above the last. Along x
/// Δ is taken to the nearest division of the bounding box of the shape's base, along y the rows to
/// the nearest whole number of them (the spacing of the particles is the geometric mean of both).
///
/// The boundary is divided evenly between its corners, about Δ apart, on the left and right edge of
/// the box at the height of the rows; inner nodes keep 0.45 Δ away from it. Where the boundary runs
/// along no row, the three layers next to it move to the centres of the triangles around them until
/// the layers follow it. Nodes are numbered column by column, y fastest.
///
/// InputError, at `place`, if the division along x changes Δ by more than 1 %, or Δ is too coarse
/// for an edge, a curve or a hole of the shape; also for a shape that `validate` refuses.
[[nodiscard]] Particles<2> hexagonal_lattice(const Shape<2>& shape, double spacing,
                                             const Place& place = {});

}  // namespace tlsph

#pragma once
/// \file
/// Bodies filled with the nodes of a rectangular or hexagonal lattice, and named parts of bodies.
///
/// A cell of a rectangular lattice belongs to the body if its centre lies in the shape; curved and
/// slanted edges become stairs of cells (filling/fitted.hpp replaces the stairs by cells that
/// follow the boundary). The volume of a node on the boundary placement is a quarter (half in 1D)
/// of each cell it belongs to, so that Σ V is the area of the cells. The boundary is made of the
/// cell edges that have a cell on one side only; half of each edge's outward area vector goes to
/// either end, hence Σ_q B_q = 0 and Σ_q B^a_q X^b_q = |Ω| δ_ab.

#include <string>

#include "tlsph/core/error.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Number of nodes a lattice of that spacing [m] would have, without building it: exact for
/// intervals and boxes (to the rounding of lengths to whole cells), an estimate |Ω|/Δ² + |∂Ω|/(2Δ)
/// + 1 otherwise. A double, because a mistyped spacing may ask for more nodes than an integer
/// holds.
template <int D>
[[nodiscard]] double lattice_size_estimate(const Shape<D>& shape, double spacing,
                                           NodePlacement placement = NodePlacement::on_boundary,
                                           const Place& place = {});

/// Nodes row by row, in the order of their LatticeFrame; cells and faces in the same; cell corners
/// and face ends counter-clockwise (the body to the left of a face).
///
/// The spacing [m] is taken, per direction, to the nearest whole division of the bounding box of
/// the shape's base. InputError, at `place`, if that changes it by more than 1 % (the message names
/// the nearest spacing that fits), if it is not a positive number, if no cell centre lies in the
/// shape, or if there would be more than 2³¹ nodes; also for a shape that `validate` refuses.
template <int D>
[[nodiscard]] Particles<D> make_lattice(const Shape<D>& shape, double spacing,
                                        NodePlacement placement = NodePlacement::on_boundary,
                                        const Place& place = {});

/// Hexagonal (triangular) lattice: every inner node has six neighbours, all as far away. Rows along
/// x, Δ apart in them, every other one shifted by Δ/2 and √3/2 Δ above the last. Along x
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

/// The same particles with one more patch: the nodes with lower ≤ X ≤ upper (tolerance 1e-6 Δ) and
/// the part of the boundary there. In 2D the faces are cut at the bounds, those between nodes on an
/// arc of `shape` where the arc meets them. InputError if the box is upside down, holds neither
/// particles nor boundary, or the name is taken.
template <int D>
[[nodiscard]] Particles<D> with_named_box(Particles<D> particles, const std::string& name,
                                          const Vector<D>& lower, const Vector<D>& upper,
                                          const Place& place = {}, const Shape<D>* shape = nullptr);

/// The same particles with a patch of those nodes and of the boundary faces between them.
/// InputError if the name is taken.
template <int D>
[[nodiscard]] Particles<D> with_named_nodes(Particles<D> particles, const std::string& name,
                                            std::vector<int> nodes, const Place& place);

}  // namespace tlsph

#pragma once
/// \file
/// The boundary faces of scattered nodes: which nodes lie on the outline of a shape, and in which
/// order.

#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {

/// Faces between nodes that follow one another along the outline, loop by loop, labelled by what
/// they border. Nodes within `tolerance` [m] of the outline are moved onto it, those within it of a
/// corner into that corner. InputError, at the place of a node (of the first one for what no node
/// is to blame for), for a node outside the shape, a corner without a node, or a loop with fewer
/// than three.
[[nodiscard]] std::vector<LabelledFace<2>> outline_faces(VectorField<2>& X, const Shape<2>& shape,
                                                         double tolerance,
                                                         const NodePlaces& places);

}  // namespace tlsph

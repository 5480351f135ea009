#pragma once
/// \file
/// Sums over cells and faces that every builder of particles needs.

#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Outward area vector [m^(d−1)] of a 2D face that runs from a to b with the body on its left.
[[nodiscard]] inline Vector<2> face_area(const Vector<2>& a, const Vector<2>& b) {
  return {b.y() - a.y(), a.x() - b.x()};
}

/// N×d lumped area vectors: each face gives equal shares to its ends.
template <int D>
[[nodiscard]] VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces);

/// A patch of those faces and their nodes.
template <int D>
[[nodiscard]] Patch<D> make_patch(std::string name, std::vector<Face<D>> faces);

}  // namespace tlsph

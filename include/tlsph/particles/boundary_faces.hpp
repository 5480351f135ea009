#pragma once
/// \file
/// From labelled boundary faces to patches and lumped area vectors: what every builder of particles
/// needs.

#include <array>
#include <string>
#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/outline_names.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Outward area vector [m^(d−1)] of a 2D face that runs from a to b with the body on its left.
[[nodiscard]] inline Vector<2> face_area(const Vector<2>& a, const Vector<2>& b) {
  return {b.y() - a.y(), a.x() - b.x()};
}

/// A face and what lies beyond it.
template <int D>
struct LabelledFace {
  Face<D> face;
  int side = no_side;  ///< what it faces, index into side_names
  int hole = 0;        ///< number of the hole it borders, from 1; 0 if none
  int edge = 0;        ///< number of the edge it is part of, from 1; 0 in 1D
};

/// The face with the edge it is part of and the side and the hole that all of `witnesses` lie on
/// (points of the true boundary, its ends first; tolerance [m]).
[[nodiscard]] LabelledFace<2> labelled(const Face<2>& face, const std::vector<Vector<2>>& witnesses,
                                       const OutlineNames& names,
                                       const std::vector<Shape<2>>& holes, double tolerance);

/// The patches every body has, as far as they hold faces: `left`, `right`, `bottom`, `top`, `hole`,
/// `hole1` …, `outer`, `boundary`.
template <int D>
[[nodiscard]] std::vector<Patch<D>> make_patches(const std::vector<LabelledFace<D>>& faces,
                                                 std::size_t holes);

/// The patches `edge1`, `edge2` …; none in 1D.
template <int D>
[[nodiscard]] std::vector<Patch<D>> make_edges(const std::vector<LabelledFace<D>>& faces);

/// N×d lumped area vectors: each face gives its ends their shares.
template <int D>
[[nodiscard]] VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces);

/// A patch of those faces and their nodes.
template <int D>
[[nodiscard]] Patch<D> make_patch(std::string name, std::vector<Face<D>> faces);

}  // namespace tlsph

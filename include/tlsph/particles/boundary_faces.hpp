#pragma once
/// \file
/// From labelled boundary faces to patches and lumped area vectors: what every builder of particles
/// needs.

#include <array>
#include <string>
#include <vector>

#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Outward area vector [m^(d−1)] of a 2D face that runs from a to b with the body on its left.
[[nodiscard]] inline Vector<2> face_area(const Vector<2>& a, const Vector<2>& b) {
  return {b.y() - a.y(), a.x() - b.x()};
}

/// Names of the sides of the bounding box: lower and upper in x, then in y.
inline constexpr std::array<const char*, 4> side_names = {"left", "right", "bottom", "top"};
inline constexpr int no_side = -1;

/// A face and what lies beyond it.
template <int D>
struct LabelledFace {
  Face<D> face;
  int side = no_side;  ///< side of the bounding box it lies on, index into side_names
  int hole = 0;        ///< number of the hole it borders, from 1; 0 if none
};

/// The face with the side of the `box`, or else the hole, that all of `witnesses` lie on (points of
/// the true boundary, tolerance [m]).
[[nodiscard]] LabelledFace<2> labelled(const Face<2>& face, const std::vector<Vector<2>>& witnesses,
                                       const Box<2>& box, const std::vector<Shape<2>>& holes,
                                       double tolerance);

/// The patches every body has, as far as they hold faces: `left`, `right`, `bottom`, `top`, `hole`,
/// `hole1` …, `outer`, `boundary`.
template <int D>
[[nodiscard]] std::vector<Patch<D>> make_patches(const std::vector<LabelledFace<D>>& faces,
                                                 std::size_t holes);

/// N×d lumped area vectors: each face gives its ends their shares.
template <int D>
[[nodiscard]] VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces);

/// A patch of those faces and their nodes.
template <int D>
[[nodiscard]] Patch<D> make_patch(std::string name, std::vector<Face<D>> faces);

}  // namespace tlsph

#pragma once
/// \file
/// From the outline of a shape to the named boundary of its particles: what the edges are called,
/// which edge, side and hole a face belongs to, and the patches and area vectors that follow. Every
/// builder of particles needs it.

#include <array>
#include <vector>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Names of edges by what they face, −x, +x, −y and +y.
inline constexpr std::array<const char*, 4> side_names = {"left", "right", "bottom", "top"};
inline constexpr int no_side = -1;

/// A face and what lies beyond it.
template <int D>
struct LabelledFace {
  Face<D> face;
  int side = no_side;  ///< what it faces, index into side_names
  int hole = 0;        ///< number of the hole it borders, from 1; 0 if none
  int edge = 0;        ///< number of the edge it is part of, from 1; 0 in 1D
};

/// A piece of the outline with the names of its edge.
struct NamedPiece {
  OutlinePiece piece;
  int edge = 0;        ///< from 1
  int side = no_side;  ///< index into side_names
};

/// The edges of a shape. They reach from corner to corner and are numbered from 1 in the order in
/// which the shape lists them: of a box bottom, right, top, left; of a polygon from its first
/// corner on; of a difference those of the base, then those of the holes. `left` are the straight
/// pieces of the outer boundary that face −x, of several those farthest out, and so on.
class OutlineNames {
 public:
  explicit OutlineNames(const Shape<2>& shape);

  /// The pieces of `outline`, in its order.
  [[nodiscard]] const std::vector<NamedPiece>& pieces() const { return pieces_; }
  /// The piece closest to x of those that face about as the vector `outward` does.
  [[nodiscard]] const NamedPiece& closest(const Vector<2>& x, const Vector<2>& outward) const;
  /// The face between nodes `from` and `to` (rows of X) with the edge it is part of and the side
  /// and the hole that both ends and all of `witnesses` lie on (points of the true boundary;
  /// tolerance [m]).
  [[nodiscard]] LabelledFace<2> labelled(const VectorField<2>& X, int from, int to,
                                         double tolerance,
                                         std::vector<Vector<2>> witnesses = {}) const;

 private:
  void name_sides(const std::vector<std::size_t>& outer_pieces);

  std::vector<NamedPiece> pieces_;
  std::vector<Shape<2>> holes_;
  double size_;  ///< of the shape [m]
};

/// Outward area vector [m^(d−1)] of a 2D face that runs from a to b with the body on its left.
[[nodiscard]] inline Vector<2> face_area(const Vector<2>& a, const Vector<2>& b) {
  return {b.y() - a.y(), a.x() - b.x()};
}

/// Gives particles with positions X what follows from their faces: the patches every body has, as
/// far as they hold faces (`left`, `right`, `bottom`, `top`, `hole`, `hole1` …, `outer`,
/// `boundary`), in 2D the edges `edge1`, `edge2` …, and the area vectors B.
template <int D>
void set_boundary(Particles<D>& particles, const std::vector<LabelledFace<D>>& faces,
                  std::size_t holes);

/// N×d lumped area vectors: each face gives its ends their shares.
template <int D>
[[nodiscard]] VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces);

}  // namespace tlsph

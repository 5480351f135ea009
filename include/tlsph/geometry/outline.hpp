#pragma once
/// \file
/// The boundary of a 2D shape as straight pieces and arcs with the body on the left. From it
/// follow, in closed form, the area of any difference of shapes, its perimeter and the closest
/// boundary point.
///
/// Method: the boundary curves of all primitives are cut where they meet; a piece belongs to the
/// outline if the body lies on exactly one of its sides; area = ½ ∮ X×dX over what is left (Green).

#include <functional>
#include <limits>
#include <vector>

#include "tlsph/core/types.hpp"
#include "tlsph/geometry/shape.hpp"

namespace tlsph {

/// A straight piece (radius 0) or an arc `centre + radius (cos φ, sin φ)`, φ from `start` over
/// `sweep` radians (counter-clockwise positive).
struct OutlinePiece {
  Vector<2> from;
  Vector<2> to;
  Vector<2> centre = Vector<2>::Zero();
  double radius = 0.0;
  double start = 0.0;
  double sweep = 0.0;

  [[nodiscard]] bool is_arc() const { return radius > 0.0; }
  /// Point at parameter t in [0, 1].
  [[nodiscard]] Vector<2> at(double t) const;
  /// Unit normal at its point x to the right of the direction of travel: outward of the body.
  [[nodiscard]] Vector<2> normal_at(const Vector<2>& x) const;
  [[nodiscard]] Vector<2> normal(double t) const { return normal_at(at(t)); }
  [[nodiscard]] double length() const;
  /// Closest point of the piece to x.
  [[nodiscard]] Vector<2> closest(const Vector<2>& x) const;
};

/// A point of some pieces, the piece it lies on and its squared distance [m²] from where it was
/// sought.
struct Foot {
  const OutlinePiece* piece = nullptr;
  Vector<2> point = Vector<2>::Zero();
  double squared = std::numeric_limits<double>::infinity();
};

/// The point of the pieces closest to x, on the first of equally close ones.
[[nodiscard]] Foot closest(const std::vector<OutlinePiece>& pieces, const Vector<2>& x);

/// Boundary pieces of the shape, in no particular order; empty if nothing is left of it. Slivers
/// thinner than 1e-7 of the shape's size are not resolved.
[[nodiscard]] std::vector<OutlinePiece> outline(const Shape<2>& shape);

/// Pieces from head to tail, closed: the next one starts where the last one ends.
using OutlineLoop = std::vector<OutlinePiece>;

/// The outline as loops, the outer boundary counter-clockwise, holes clockwise.
[[nodiscard]] std::vector<OutlineLoop> outline_loops(const Shape<2>& shape);

/// The point that far [m] along pieces from head to tail.
[[nodiscard]] Vector<2> point_along(const OutlineLoop& pieces, double distance);

/// True where the boundary turns by more than 20° from one piece into the next: a corner.
[[nodiscard]] bool is_corner(const OutlinePiece& piece, const OutlinePiece& next);

/// Whether a point between two pieces divides the outline.
using Breaks = std::function<bool(const OutlinePiece& piece, const OutlinePiece& next)>;

/// The parts of a loop from break to break; a loop without breaks is one part.
[[nodiscard]] std::vector<OutlineLoop> sections(const OutlineLoop& loop,
                                                const Breaks& breaks = is_corner);

/// ½ ∮ X×dX [m²] over closed pieces.
[[nodiscard]] double enclosed_area(const std::vector<OutlinePiece>& pieces);

}  // namespace tlsph

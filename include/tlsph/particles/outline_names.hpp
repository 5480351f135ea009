#pragma once
/// \file
/// What the edges of a shape are called.

#include <array>
#include <vector>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/shape.hpp"

namespace tlsph {

/// Names of edges by what they face, −x, +x, −y and +y.
inline constexpr std::array<const char*, 4> side_names = {"left", "right", "bottom", "top"};
inline constexpr int no_side = -1;

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

 private:
  void number_edges(const std::vector<std::vector<std::size_t>>& loops);
  void name_sides(const std::vector<std::size_t>& outer_pieces);

  std::vector<NamedPiece> pieces_;
  double size_;  ///< of the shape [m]
};

}  // namespace tlsph

#pragma once
/// \file
/// The outline of a shape as a lattice sees it, for filling/fitted.cpp.

#include <optional>
#include <vector>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// The outline split into `straight` pieces, which lie on lattice lines, and the rest, the `curve`.
class SplitOutline {
 public:
  SplitOutline(const Particles<2>& lattice, const Shape<2>& shape);

  [[nodiscard]] const Box<2>& box() const { return box_; }
  [[nodiscard]] bool has_curve() const { return !curve_.empty(); }
  /// Points closer than this [m] are one.
  [[nodiscard]] double tolerance() const { return 1e-8 * spacing_.minCoeff(); }

  [[nodiscard]] Vector<2> closest_on_curve(const Vector<2>& x) const;
  [[nodiscard]] double distance_to_curve(const Vector<2>& x) const;
  [[nodiscard]] bool on_straight(const Vector<2>& x) const;
  /// Outward unit normal of the whole outline at its point closest to x.
  [[nodiscard]] Vector<2> normal(const Vector<2>& x) const;
  /// Where the curve meets the straight piece that x lies on, of several such points the closest to
  /// x; nothing if they do not meet.
  [[nodiscard]] std::optional<Vector<2>> junction(const Vector<2>& x) const;
  /// Points of the curve that must be nodes (`breaks`).
  [[nodiscard]] const std::vector<Vector<2>>& kinks() const { return kinks_; }
  /// Points of the whole outline that must be nodes.
  [[nodiscard]] const std::vector<Vector<2>>& corners() const { return corners_; }

  /// Points of the whole outline, at most `step` [m] apart.
  [[nodiscard]] std::vector<Vector<2>> samples(double step) const;

 private:
  [[nodiscard]] bool on_lattice_line(const OutlinePiece& piece) const;

  Box<2> box_;
  Vector<2> spacing_;
  std::vector<OutlinePiece> straight_, curve_;
  std::vector<Vector<2>> kinks_, corners_;
};

}  // namespace tlsph

#pragma once
/// \file
/// The outline of a shape from corner to corner, divided into edges of blocks, for
/// filling/block_fill.cpp, and as a lattice sees it, for filling/fitted.cpp.

#include <array>
#include <optional>
#include <vector>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Ascending coordinates [m] of the lines between blocks, per direction.
using BlockLines = std::array<std::vector<double>, 2>;

/// Must a node stand between the two pieces: at a corner (`is_corner`), and at any smaller turn
/// between pieces longer than 1.5 spacings; between shorter ones it is part of a curve.
[[nodiscard]] bool breaks(const OutlinePiece& piece, const OutlinePiece& next, double spacing);

/// Pieces of the outline from corner to corner, body on the left; closed if the loop has no corner.
struct OutlineSection {
  OutlineLoop pieces;
  double length = 0.0;  ///< [m]
  bool closed = false;
  bool on_line = false;  ///< lies on a line between blocks
  std::size_t next = 0;  ///< section that starts where this one ends
  std::vector<double>
      stops{};  ///< distances [m] of the ends of the block edges, from 0 to `length`
};

/// The sections of a shape, divided into block edges about `size` [m] long. Where a section lies on
/// a line between blocks the edges end at the lines that cross it; next to a corner of less than
/// 60° the first edges of both sections are of one length.
class OutlineSections {
 public:
  OutlineSections(const Shape<2>& shape, double size);

  [[nodiscard]] const std::vector<OutlineSection>& all() const { return sections_; }
  [[nodiscard]] const BlockLines& lines() const { return lines_; }
  /// Distance [m] of x to the sections; of `off_lines`, to those that lie on no line.
  [[nodiscard]] double distance(const Vector<2>& x, bool off_lines) const;

 private:
  void add_loop(const OutlineLoop& loop);
  void choose_lines(const Shape<2>& shape);
  void divide(OutlineSection& section) const;
  void match_acute_corners();

  double size_;
  std::vector<OutlineSection> sections_;
  BlockLines lines_;
};

/// The outline split into `straight` pieces, which lie on lattice lines, and the rest, the `curve`.
class SplitOutline {
 public:
  SplitOutline(const Particles<2>& lattice, const Shape<2>& shape);

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

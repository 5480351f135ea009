#pragma once
/// \file
/// The outline of a shape from corner to corner, divided into edges of blocks, for
/// filling/block_fill.cpp.

#include <array>
#include <vector>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/shape.hpp"

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

}  // namespace tlsph

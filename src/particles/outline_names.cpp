#include "tlsph/particles/outline_names.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// Lengths below this share of the size of the shape are rounding.
constexpr double rounding = 1e-9;

bool same(const OutlinePiece& a, const OutlinePiece& b) {
  return a.from == b.from && a.to == b.to && a.centre == b.centre && a.radius == b.radius;
}

}  // namespace

OutlineNames::OutlineNames(const Shape<2>& shape) {
  const Box<2> box = bounding_box(shape);
  size_ = (box.upper - box.lower).norm();
  for (const OutlinePiece& piece : outline(shape)) pieces_.push_back({piece});
  std::vector<std::vector<std::size_t>> loops;
  std::vector<std::size_t> outer;
  for (const OutlineLoop& loop : outline_loops(shape)) {
    loops.emplace_back();
    for (const OutlinePiece& piece : loop) {
      const auto found = std::ranges::find_if(
          pieces_, [&](const NamedPiece& named) { return same(named.piece, piece); });
      loops.back().push_back(static_cast<std::size_t>(found - pieces_.begin()));
    }
    if (enclosed_area(loop) > 0.0)
      outer.insert(outer.end(), loops.back().begin(), loops.back().end());
  }
  number_edges(loops);
  name_sides(outer);
}

void OutlineNames::number_edges(const std::vector<std::vector<std::size_t>>& loops) {
  std::vector<std::vector<std::size_t>> edges;
  for (const auto& loop : loops) {
    const std::size_t count = loop.size();
    const auto corner_before = [&](std::size_t k) {
      return is_corner(pieces_[loop[(k + count - 1) % count]].piece, pieces_[loop[k]].piece);
    };
    std::size_t first = 0;
    while (first + 1 < count && !corner_before(first)) ++first;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = (first + k) % count;
      if (k == 0 || corner_before(at)) edges.emplace_back();
      edges.back().push_back(loop[at]);
    }
  }
  std::ranges::sort(edges, {}, [](const auto& edge) { return std::ranges::min(edge); });
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::size_t k : edges[e]) pieces_[k].edge = static_cast<int>(e) + 1;
}

void OutlineNames::name_sides(const std::vector<std::size_t>& outer_pieces) {
  for (int side = 0; side < 4; ++side) {
    const int a = side / 2;
    const double outward = side % 2 == 0 ? -1.0 : 1.0;
    double farthest = -std::numeric_limits<double>::infinity();
    const auto faces_it = [&](const OutlinePiece& piece) {
      return !piece.is_arc() && std::abs(piece.to(a) - piece.from(a)) <= rounding * size_ &&
             outward * piece.normal(0.5)(a) > 0.5;
    };
    for (const std::size_t k : outer_pieces)
      if (const OutlinePiece& piece = pieces_[k].piece; faces_it(piece))
        farthest = std::max(farthest, outward * piece.from(a));
    for (const std::size_t k : outer_pieces)
      if (const OutlinePiece& piece = pieces_[k].piece;
          faces_it(piece) && outward * piece.from(a) >= farthest - rounding * size_)
        pieces_[k].side = side;
  }
}

const NamedPiece& OutlineNames::closest(const Vector<2>& x, const Vector<2>& outward) const {
  const NamedPiece* best = &pieces_.front();
  double least = std::numeric_limits<double>::infinity();
  for (const NamedPiece& named : pieces_) {
    const OutlinePiece& piece = named.piece;
    const Vector<2> on = piece.closest(x);
    const Vector<2> normal = piece.is_arc()
                                 ? Vector<2>(std::copysign(1.0, piece.sweep) * (on - piece.centre))
                                 : piece.normal(0.5);
    const double distance = (on - x).norm() + (normal.dot(outward) > 0.0 ? 0.0 : size_);
    if (distance >= least) continue;
    least = distance;
    best = &named;
  }
  return *best;
}

}  // namespace tlsph

#include "split_outline.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "outline_sections.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
SplitOutline::SplitOutline(const Particles<2>& lattice, const Shape<2>& shape)
    : box_(bounding_box(shape)), spacing_(lattice.spacings) {
  const std::vector<OutlinePiece> pieces = outline(shape);
  std::ranges::partition_copy(pieces, std::back_inserter(straight_), std::back_inserter(curve_),
                              [this](const OutlinePiece& piece) { return on_lattice_line(piece); });
  const auto breaks_of = [&](const std::vector<OutlinePiece>& of) {
    std::vector<Vector<2>> points;
    for (const auto& a : of)
      for (const auto& b : of)
        if ((a.to - b.from).norm() <= tolerance() && breaks(a, b, lattice.spacing))
          points.push_back(a.to);
    return points;
  };
  kinks_ = breaks_of(curve_);
  corners_ = breaks_of(pieces);
}

Vector<2> SplitOutline::closest_on_curve(const Vector<2>& x) const {
  return closest(curve_, x).point;
}

double SplitOutline::distance_to_curve(const Vector<2>& x) const {
  return std::sqrt(closest(curve_, x).squared);
}

bool SplitOutline::on_straight(const Vector<2>& x) const {
  return std::sqrt(closest(straight_, x).squared) <= tolerance();
}

Vector<2> SplitOutline::normal(const Vector<2>& x) const {
  Foot foot = closest(straight_, x);
  if (const Foot other = closest(curve_, x); other.squared < foot.squared) foot = other;
  return foot.piece->normal_at(foot.point);
}

std::optional<Vector<2>> SplitOutline::junction(const Vector<2>& x) const {
  std::optional<Vector<2>> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& piece : straight_) {
    if ((piece.closest(x) - x).norm() > tolerance()) continue;
    for (const Vector<2>& end : {piece.from, piece.to})
      if ((end - x).norm() < least && distance_to_curve(end) <= tolerance()) {
        least = (end - x).norm();
        best = end;
      }
  }
  return best;
}

std::vector<Vector<2>> SplitOutline::samples(double step) const {
  std::vector<Vector<2>> points;
  for (const auto* pieces : {&straight_, &curve_})
    for (const auto& piece : *pieces) {
      const double count = std::ceil(piece.length() / step);
      for (double k = 0.0; k < count; k += 1.0) points.push_back(piece.at(k / count));
    }
  return points;
}

bool SplitOutline::on_lattice_line(const OutlinePiece& piece) const {
  if (piece.is_arc()) return false;
  for (int a = 0; a < 2; ++a) {
    const double line = (piece.from(a) - box_.lower(a)) / spacing_(a);
    if (std::abs(piece.from(a) - piece.to(a)) <= tolerance() &&
        std::abs(line - std::round(line)) <= 1e-8)
      return true;
  }
  return false;
}

}  // namespace tlsph

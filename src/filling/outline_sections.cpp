#include "outline_sections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "tlsph/geometry/polygon.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// Points closer than this, in block sizes, are one.
constexpr double merged = 1e-8;
/// Lines between blocks stay that far apart, and the first stop of a section on a line from a
/// corner that is on none, in block sizes.
constexpr double least_line_gap = 0.75;
constexpr double least_rest = 0.5;
constexpr double largest_sweep = 0.5 * std::numbers::pi;
constexpr double acute_cosine = 0.5;

/// The axis that a straight section is normal to; −1 for others.
int normal_axis(const OutlineSection& section, double tolerance) {
  if (section.pieces.size() != 1 || section.pieces[0].is_arc()) return -1;
  for (int a = 0; a < 2; ++a)
    if (std::abs(section.pieces[0].from(a) - section.pieces[0].to(a)) <= tolerance) return a;
  return -1;
}

void push_even(std::vector<double>& stops, double end, double size, double least_count) {
  const double start = stops.back();
  const double count = std::max(least_count, std::round((end - start) / size));
  for (double k = 1.0; k <= count; k += 1.0) stops.push_back(start + (end - start) * k / count);
  stops.back() = end;
}

}  // namespace

bool breaks(const OutlinePiece& piece, const OutlinePiece& next, double spacing) {
  constexpr double smooth_cosine = 1.0 - 1e-10;
  constexpr double long_piece = 1.5;
  return is_corner(piece, next) || (piece.normal(1.0).dot(next.normal(0.0)) < smooth_cosine &&
                                    std::min(piece.length(), next.length()) > long_piece * spacing);
}

OutlineSections::OutlineSections(const Shape<2>& shape, double size) : size_(size) {
  for (const OutlineLoop& loop : outline_loops(shape)) add_loop(loop);
  choose_lines(shape);
  for (OutlineSection& section : sections_) {
    const int a = normal_axis(section, merged * size_);
    section.on_line =
        a >= 0 && std::ranges::any_of(lines_[static_cast<std::size_t>(a)], [&](double line) {
          return std::abs(line - section.pieces.front().from(a)) <= merged * size_;
        });
    divide(section);
  }
  match_acute_corners();
}

double OutlineSections::distance(const Vector<2>& x, bool off_lines) const {
  double least = std::numeric_limits<double>::infinity();
  for (const OutlineSection& section : sections_)
    if (!off_lines || !section.on_line) least = std::min(least, closest(section.pieces, x).squared);
  return std::sqrt(least);
}

void OutlineSections::add_loop(const OutlineLoop& loop) {
  const auto ends = [&](const OutlinePiece& piece, const OutlinePiece& next) {
    return breaks(piece, next, 0.5 * size_);
  };
  const std::size_t begin = sections_.size();
  for (OutlineLoop& pieces : sections(loop, ends)) {
    OutlineSection& section = sections_.emplace_back();
    for (const OutlinePiece& piece : pieces) section.length += piece.length();
    section.closed = pieces.size() == loop.size() && !ends(pieces.back(), pieces.front());
    section.pieces = std::move(pieces);
    section.next = sections_.size();
  }
  sections_.back().next = begin;
}

void OutlineSections::choose_lines(const Shape<2>& shape) {
  const Box<2> box = bounding_box(shape);
  for (int a = 0; a < 2; ++a) {
    std::vector<std::pair<double, double>> walls;  // length, coordinate
    for (const OutlineSection& section : sections_)
      if (normal_axis(section, merged * size_) == a)
        walls.emplace_back(section.length, section.pieces.front().from(a));
    std::ranges::sort(walls, std::greater<>());
    std::vector<double> chosen = {box.lower(a), box.upper(a)};
    for (const auto& [length, line] : walls)
      if (std::ranges::all_of(chosen, [&, at = line](double other) {
            return std::abs(other - at) >= least_line_gap * size_;
          }))
        chosen.push_back(line);
    std::ranges::sort(chosen);
    std::vector<double>& lines = lines_[static_cast<std::size_t>(a)];
    lines = {chosen.front()};
    for (std::size_t k = 1; k < chosen.size(); ++k) push_even(lines, chosen[k], size_, 1.0);
  }
}

void OutlineSections::divide(OutlineSection& section) const {
  section.stops = {0.0};
  if (!section.on_line) {
    double sweep = 0.0;
    for (const OutlinePiece& piece : section.pieces) sweep += std::abs(piece.sweep);
    push_even(section.stops, section.length, size_,
              std::max({1.0, std::ceil(sweep / largest_sweep - 1e-9), section.closed ? 4.0 : 1.0}));
    return;
  }
  const Vector<2> from = section.pieces.front().from, to = section.pieces.back().to;
  const int along = std::abs(to.x() - from.x()) > std::abs(to.y() - from.y()) ? 0 : 1;
  const auto& lines = lines_[static_cast<std::size_t>(along)];
  const auto on_crossing = [&](const Vector<2>& x) {
    return std::ranges::any_of(
        lines, [&](double line) { return std::abs(line - x(along)) <= merged * size_; });
  };
  const double after = on_crossing(from) ? merged * size_ : least_rest * size_;
  const double before = section.length - (on_crossing(to) ? merged * size_ : least_rest * size_);
  for (const double line : lines) {
    const double distance = std::abs(line - from(along));
    if ((line - from(along)) * (to(along) - from(along)) > 0.0 && distance > after &&
        distance < before)
      section.stops.push_back(distance);
  }
  std::ranges::sort(section.stops);
  section.stops.push_back(section.length);
}

void OutlineSections::match_acute_corners() {
  std::vector<std::array<double, 2>> wanted(sections_.size(), {0.0, 0.0});  // at start and end
  for (std::size_t s = 0; s < sections_.size(); ++s) {
    const OutlineSection &in = sections_[s], &out = sections_[in.next];
    if (in.closed || in.next == s) continue;
    // Tangents, into the corner and out of it: the inner angle is acute if they are nearly opposed
    // and the boundary turns left.
    const Vector<2> n = in.pieces.back().normal(1.0), m = out.pieces.front().normal(0.0);
    if (n.dot(m) > -acute_cosine || cross(n, m) <= 0.0) continue;
    const double last = in.length - in.stops[in.stops.size() - 2], first = out.stops[1];
    const bool in_fixed = in.on_line || in.stops.size() == 2;
    const bool out_fixed = out.on_line || out.stops.size() == 2;
    if (in_fixed && out_fixed) continue;
    const double common = in_fixed ? last : out_fixed ? first : 0.5 * (first + last);
    if (!in_fixed) wanted[s][1] = common;
    if (!out_fixed) wanted[in.next][0] = common;
  }
  for (std::size_t s = 0; s < sections_.size(); ++s) {
    const auto [first, last] = wanted[s];
    OutlineSection& section = sections_[s];
    const double rest = section.length - first - last;
    if ((first == 0.0 && last == 0.0) || rest < (first > 0.0 && last > 0.0 ? 0.0 : 0.5) * size_)
      continue;
    section.stops = {0.0};
    if (first > 0.0) section.stops.push_back(first);
    if (rest > least_rest * size_)
      push_even(section.stops, section.length - last, size_, 1.0);
    else  // both first edges nearly meet: let them
      section.stops.back() = section.length * first / (first + last);
    if (last > 0.0) section.stops.push_back(section.length);
  }
}

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

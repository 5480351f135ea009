#include "tlsph/filling/cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// A node on a piece of the outline, at that share of the piece.
struct Stop {
  double share = 0.0;
  int node = 0;
};

/// Share of the piece at which its point closest to x lies.
double share_at(const OutlinePiece& piece, const Vector<2>& x) {
  if (!piece.is_arc()) {
    const Vector<2> along = piece.to - piece.from;
    return std::clamp(along.dot(x - piece.from) / along.squaredNorm(), 0.0, 1.0);
  }
  const Vector<2> arm = x - piece.centre;
  constexpr double turn = 2.0 * std::numbers::pi;
  double angle =
      std::copysign(1.0, piece.sweep) * (std::atan2(arm.y(), arm.x()) - piece.start) / turn;
  angle = turn * (angle - std::floor(angle));
  const double sweep = std::abs(piece.sweep);
  if (angle <= sweep) return angle / sweep;
  return angle - sweep < turn - angle ? 1.0 : 0.0;  // just beyond the one end or the other
}

/// Puts the nodes near the outline onto it; those on it, by piece, in the order they are met.
class Stops {
 public:
  Stops(const std::vector<OutlineLoop>& loops, VectorField<2>& X, double tolerance)
      : loops_(loops), tolerance_(tolerance) {
    for (const auto& loop : loops) stops_.emplace_back(loop.size());
    for (int q = 0; q < static_cast<int>(X.rows()); ++q) place(X, q);
    for (auto& loop : stops_)
      for (auto& piece : loop)
        std::sort(piece.begin(), piece.end(),
                  [](const Stop& a, const Stop& b) { return a.share < b.share; });
  }

  /// Nodes once around that loop, each once.
  [[nodiscard]] std::vector<int> around(std::size_t loop) const {
    std::vector<int> nodes;
    for (const auto& piece : stops_[loop])
      for (const Stop& stop : piece)
        if (nodes.empty() || nodes.back() != stop.node) nodes.push_back(stop.node);
    if (nodes.size() > 1 && nodes.front() == nodes.back()) nodes.pop_back();
    return nodes;
  }

 private:
  void place(VectorField<2>& X, int node) {
    const Vector<2> x = X.row(node).transpose();
    const OutlinePiece* closest = nullptr;
    double least = tolerance_;
    for (const auto& loop : loops_)
      for (const auto& piece : loop) {
        const double distance = (piece.closest(x) - x).norm();
        if (distance > least) continue;
        least = distance;
        closest = &piece;
      }
    if (closest == nullptr) return;
    Vector<2> on = closest->closest(x);
    for (const auto& loop : loops_)
      for (std::size_t k = 0; k < loop.size(); ++k)
        if (is_corner(loop[k], loop[(k + 1) % loop.size()]) &&
            (loop[k].to - x).norm() <= tolerance_)
          on = loop[k].to;
    X.row(node) = on.transpose();
    // Where two pieces meet the node is on both; `around` counts it once.
    for (std::size_t l = 0; l < loops_.size(); ++l)
      for (std::size_t k = 0; k < loops_[l].size(); ++k)
        if ((loops_[l][k].closest(on) - on).norm() <= 1e-3 * tolerance_)
          stops_[l][k].push_back({share_at(loops_[l][k], on), node});
  }

  const std::vector<OutlineLoop>& loops_;
  double tolerance_;
  std::vector<std::vector<std::vector<Stop>>> stops_;  // by loop and piece
};

void refuse_outside(const VectorField<2>& X, const Shape<2>& shape, double tolerance,
                    const NodePlaces& places) {
  for (Index q = 0; q < X.rows(); ++q) {
    const double inside = depth(shape, Vector<2>(X.row(q).transpose()));
    if (!(inside >= -tolerance))
      throw InputError(places(q), fmt::format("the point {} lies outside the shape, {:.3g} m "
                                              "from it",
                                              position_text(X.row(q).transpose()), -inside));
  }
}

void require_corner(const VectorField<2>& X, const Vector<2>& corner, const NodePlaces& places) {
  Index nearest = 0;
  const double distance = (X.rowwise() - corner.transpose()).rowwise().norm().minCoeff(&nearest);
  if (distance > 0.0)
    throw InputError(
        places(nearest),
        fmt::format("the shape has a corner at {}, the nearest point is {}, {:.3g} m "
                    "away; every corner must be a point",
                    position_text(corner), position_text(X.row(nearest).transpose()), distance));
}

}  // namespace

std::vector<LabelledFace<2>> outline_faces(VectorField<2>& X, const Shape<2>& shape,
                                           double tolerance, const NodePlaces& places) {
  refuse_outside(X, shape, tolerance, places);
  const std::vector<OutlineLoop> loops = outline_loops(shape);
  const Stops stops(loops, X, tolerance);
  const OutlineNames names(shape);
  std::vector<LabelledFace<2>> faces;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const OutlineLoop& loop = loops[l];
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (is_corner(loop[k], loop[(k + 1) % loop.size()])) require_corner(X, loop[k].to, places);
    const std::vector<int> nodes = stops.around(l);
    if (nodes.size() < 3)
      throw InputError(places(nodes.empty() ? 0 : nodes.front()),
                       fmt::format("too few points on the boundary: {} on the loop through {}, "
                                   "which needs at least three; points within {:.3g} m of it count",
                                   nodes.size(), position_text(loop.front().from), tolerance));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const int from = nodes[k], to = nodes[(k + 1) % nodes.size()];
      const Vector<2> chord = 0.5 * (X.row(from) + X.row(to)).transpose();
      faces.push_back(names.labelled(X, from, to, tolerance, {closest(loop, chord).point}));
    }
  }
  return faces;
}

}  // namespace tlsph

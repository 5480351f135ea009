#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "outline_sections.hpp"
#include "quad_mesh.hpp"
#include "tlsph/geometry/polygon.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

/// Distance that corners of square blocks keep from the outline where it lies on no line between
/// blocks, in block sizes.
constexpr double block_clearance = 0.6;
constexpr int rounds = 60;
/// Nodes that many edges from the triangles and the outline's own blocks move.
constexpr int moved_rings = 2;
constexpr double enough = 0.85;

/// A node on the outline: its section and its distance from the section's start [m].
struct OnSection {
  std::size_t section = 0;
  double distance = 0.0;
};

/// The blocks while they are built. Nodes of the outline come first.
class Blocks {
 public:
  Blocks(const Shape<2>& shape, double size) : shape_(shape), size_(size), outline_(shape, size) {
    place_outline();
    place_squares();
    failed_ = fill_rest();
  }

  [[nodiscard]] BlockFill cells(double spacing) const;

 private:
  void place_outline();
  void place_squares();
  std::optional<Vector<2>> fill_rest();
  [[nodiscard]] bool is_square(const Cell<2>& block) const;
  [[nodiscard]] const Vector<2>& x(int node) const { return X_[static_cast<std::size_t>(node)]; }

  const Shape<2>& shape_;
  double size_;
  OutlineSections outline_;
  std::vector<Vector<2>> X_;
  std::map<DirectedEdge, std::array<OnSection, 2>> outline_edges_;
  std::vector<Cell<2>> quads_;
  std::size_t squares_ = 0;  // the first of `quads_`
  std::vector<Triangle> triangles_;
  std::optional<Vector<2>> failed_;
};

void Blocks::place_outline() {
  const auto& sections = outline_.all();
  std::vector<int> first;
  for (const OutlineSection& section : sections) {
    first.push_back(static_cast<int>(X_.size()));
    for (std::size_t k = 0; k + 1 < section.stops.size(); ++k)
      X_.push_back(point_along(section.pieces, section.stops[k]));
  }
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const auto& stops = sections[s].stops;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const int from = first[s] + static_cast<int>(k);
      const int to = k + 2 < stops.size() ? from + 1 : first[sections[s].next];
      outline_edges_[{from, to}] = {OnSection{s, stops[k]}, OnSection{s, stops[k + 1]}};
    }
  }
}

/// May the lattice's square be a block: inside, clear of the outline or with a whole block edge on
/// it.
bool Blocks::is_square(const Cell<2>& block) const {
  Vector<2> centre = Vector<2>::Zero();
  for (const int node : block) {
    if (node < 0) return false;
    centre += 0.25 * x(node);
  }
  if (!(depth(shape_, centre) > 0.0)) return false;
  const auto clear = [&](const Vector<2>& x) {
    return outline_.distance(x, true) >= block_clearance * size_;
  };
  if (!clear(centre)) return false;
  for (std::size_t k = 0; k < 4; ++k) {
    const DirectedEdge edge = {block[k], block[(k + 1) % 4]};
    const Vector<2>&a = x(edge[0]), &b = x(edge[1]);
    if (!clear(a) || !clear(0.5 * (a + b))) return false;
    if (!outline_edges_.contains(edge) && outline_.distance(0.5 * (a + b), false) < 1e-6 * size_)
      return false;
  }
  return true;
}

void Blocks::place_squares() {
  const auto& [x, y] = outline_.lines();
  std::vector<int> number(x.size() * y.size(), -1);
  const auto outline_count = X_.size();
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) {
      const Vector<2> at(x[i], y[j]);
      const double distance = outline_.distance(at, false);
      int& mine = number[i * y.size() + j];
      if (distance >= block_clearance * size_ && depth(shape_, at) > 0.0) {
        mine = static_cast<int>(X_.size());
        X_.push_back(at);
      } else if (distance < 1e-6 * size_) {
        for (std::size_t q = 0; q < outline_count; ++q)
          if ((X_[q] - at).norm() < 1e-6 * size_) mine = static_cast<int>(q);
      }
    }
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      const std::size_t at = i * y.size() + j;
      const Cell<2> block = {number[at], number[at + y.size()], number[at + y.size() + 1],
                             number[at + 1]};
      if (is_square(block)) quads_.push_back(block);
    }
  squares_ = quads_.size();
}

/// Fills what the squares leave with triangles and pairs of them; a point where that fails.
std::optional<Vector<2>> Blocks::fill_rest() {
  std::set<DirectedEdge> sides;
  for (const Cell<2>& block : quads_)
    for (std::size_t k = 0; k < 4; ++k) sides.insert({block[k], block[(k + 1) % 4]});
  std::vector<DirectedEdge> edges;
  for (const auto& [edge, ends] : outline_edges_)
    if (!sides.contains(edge)) edges.push_back(edge);
  for (const DirectedEdge& side : sides) {
    const DirectedEdge back = {side[1], side[0]};
    if (!sides.contains(back) && !outline_edges_.contains(side)) edges.push_back(back);
  }
  if (edges.empty()) return {};
  // Nodes surrounded by squares take no part.
  std::vector<char> used(X_.size(), 1);
  for (const Cell<2>& block : quads_)
    for (const int node : block) used[static_cast<std::size_t>(node)] = 0;
  for (const DirectedEdge& edge : edges)
    for (const int node : edge) used[static_cast<std::size_t>(node)] = 1;
  std::vector<int> node_of, number(X_.size(), -1);
  for (std::size_t q = 0; q < X_.size(); ++q)
    if (used[q]) {
      number[q] = static_cast<int>(node_of.size());
      node_of.push_back(static_cast<int>(q));
    }
  const VectorField<2> X = as_rows(X_)(node_of, Eigen::all);
  for (DirectedEdge& edge : edges)
    for (int& node : edge) node = number[static_cast<std::size_t>(node)];
  auto [triangles, failed] = triangles_between(X, edges);
  if (failed >= 0) return X.row(failed).transpose();
  std::vector<Cell<2>> pairs = paired(X, triangles);
  const auto back = [&](auto& nodes) {
    for (int& node : nodes) node = node_of[static_cast<std::size_t>(node)];
  };
  std::ranges::for_each(triangles, back);
  std::ranges::for_each(pairs, back);
  quads_.insert(quads_.end(), pairs.begin(), pairs.end());
  triangles_ = std::move(triangles);
  return {};
}

BlockFill Blocks::cells(double spacing) const {
  BlockFill result;
  if (failed_) {
    result.worst = *failed_;
    return result;
  }
  std::vector<Vector<2>> X = X_;
  std::vector<int> ring(X.size(), moved_rings + 1);
  std::map<int, std::size_t> section_of;  // nodes on the outline that may slide
  for (const auto& [edge, ends] : outline_edges_) {
    const OutlineSection& section = outline_.all()[ends[0].section];
    if (ends[0].distance > 0.0 || section.closed) section_of[edge[0]] = ends[0].section;
  }
  std::map<DirectedEdge, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, fresh] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(X.size()));
    if (!fresh) return found->second;
    const auto on =
        outline_edges_.contains({a, b}) ? outline_edges_.find({a, b}) : outline_edges_.find({b, a});
    if (on == outline_edges_.end()) {
      X.push_back(0.5 * (X[static_cast<std::size_t>(a)] + X[static_cast<std::size_t>(b)]));
    } else {
      const auto& [from, to] = on->second;
      section_of[found->second] = from.section;
      X.push_back(
          point_along(outline_.all()[from.section].pieces, 0.5 * (from.distance + to.distance)));
    }
    ring.push_back(moved_rings + 1);
    return found->second;
  };
  QuadMesh& mesh = result.mesh;
  const auto cut = [&](const auto& block, bool regular) {
    Vector<2> mean = Vector<2>::Zero();
    for (const int node : block)
      mean += X[static_cast<std::size_t>(node)] / static_cast<double>(block.size());
    std::vector<int> middle_of;
    for (std::size_t k = 0; k < block.size(); ++k)
      middle_of.push_back(middle(block[k], block[(k + 1) % block.size()]));
    const int centre = static_cast<int>(X.size());
    X.push_back(mean);
    ring.push_back(regular ? moved_rings + 1 : 0);
    for (std::size_t k = 0; k < block.size(); ++k) {
      const std::size_t before = (k + block.size() - 1) % block.size();
      mesh.cells.push_back({block[k], middle_of[k], centre, middle_of[before]});
      if (!regular)
        for (const int node : {block[k], middle_of[k]}) ring[static_cast<std::size_t>(node)] = 0;
    }
  };
  for (std::size_t k = 0; k < quads_.size(); ++k) cut(quads_[k], k < squares_);
  for (const Triangle& triangle : triangles_) cut(triangle, false);
  mesh.X = as_rows(X);

  count_rings(mesh.cells, moved_rings, ring);
  std::set<int> corners;
  for (const DirectedEdge& edge : free_edges(mesh.cells)) corners.insert({edge[0], edge[1]});
  std::vector<Track> tracks(X.size());
  for (std::size_t q = 0; q < X.size(); ++q) {
    if (ring[q] > moved_rings) continue;
    const auto on = section_of.find(static_cast<int>(q));
    if (on != section_of.end()) {
      const OutlineSection& section = outline_.all()[on->second];
      tracks[q] = [&section](const Vector<2>& x) { return closest(section.pieces, x).point; };
    } else if (!corners.contains(static_cast<int>(q))) {
      tracks[q] = [](const Vector<2>& x) { return x; };
    }
  }
  improve(mesh, tracks, rounds, spacing, enough);

  result.quality = std::numeric_limits<double>::infinity();
  for (const Cell<2>& cell : mesh.cells) {
    const double quality = cell_quality(mesh.X, cell, spacing);
    if (quality >= result.quality) continue;
    result.quality = quality;
    result.worst = cell_centre<2>(mesh.X, cell);
  }
  return result;
}

}  // namespace

BlockFill fill_with_blocks(const Shape<2>& shape, double spacing) {
  return Blocks(shape, 2.0 * spacing).cells(spacing);
}

}  // namespace tlsph

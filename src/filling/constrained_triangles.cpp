#include <algorithm>
#include <map>
#include <set>

#include <Eigen/LU>

#include "quad_mesh.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

using Edge = DirectedEdge;

/// Quadrilaterals with a smaller quality than this stay two triangles.
constexpr double least_paired = 0.35;

double area(const VectorField<2>& X, int a, int b, int c) {
  return triangle_area(X, {a, b, c});
}

bool cross(const VectorField<2>& X, const Edge& e, const Edge& f) {
  for (const int node : e)
    if (node == f[0] || node == f[1]) return false;
  return area(X, e[0], e[1], f[0]) * area(X, e[0], e[1], f[1]) < 0.0 &&
         area(X, f[0], f[1], e[0]) * area(X, f[0], f[1], e[1]) < 0.0;
}

/// Is d inside the circle through the counter-clockwise a, b, c?
bool in_circle(const VectorField<2>& X, int a, int b, int c, int d) {
  Eigen::Matrix3d m;
  int row = 0;
  for (const int node : {a, b, c}) {
    const Vector<2> v = (X.row(node) - X.row(d)).transpose();
    m.row(row++) << v.x(), v.y(), v.squaredNorm();
  }
  return m.determinant() > 0.0;
}

/// Triangles on the left of the edge from → to, under the chain of nodes that leads from `to` back
/// to `from`.
void fill_chain(const VectorField<2>& X, int from, int to, const std::vector<int>& chain,
                std::vector<Triangle>& triangles) {
  if (chain.empty()) return;
  std::size_t best = 0;
  for (std::size_t k = 1; k < chain.size(); ++k)
    if (in_circle(X, from, to, chain[best], chain[k])) best = k;
  const auto middle = chain.begin() + static_cast<std::ptrdiff_t>(best);
  triangles.push_back({from, to, *middle});
  fill_chain(X, *middle, to, {chain.begin(), middle}, triangles);
  fill_chain(X, from, *middle, {middle + 1, chain.end()}, triangles);
}

/// Replaces the triangles that the edge crosses by triangles on both sides of it; false if the
/// crossed ones do not surround it.
bool insert_edge(const VectorField<2>& X, const Edge& edge, std::vector<Triangle>& triangles) {
  std::map<int, int> next;  // around the crossed triangles
  std::set<Edge> sides;
  std::erase_if(triangles, [&](const Triangle& t) {
    bool crossed = false;
    for (std::size_t k = 0; k < 3; ++k) crossed |= cross(X, edge, {t[k], t[(k + 1) % 3]});
    if (crossed)
      for (std::size_t k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
    return crossed;
  });
  for (const auto& [from, to] : sides)
    if (!sides.contains({to, from}) && !next.emplace(from, to).second) return false;
  for (int side = 0; side < 2; ++side) {
    const int from = side == 0 ? edge[0] : edge[1], to = side == 0 ? edge[1] : edge[0];
    std::vector<int> chain;
    for (auto step = next.find(to); step == next.end() || step->second != from;
         step = next.find(step->second)) {
      if (step == next.end() || chain.size() > next.size()) return false;
      chain.push_back(step->second);
    }
    fill_chain(X, from, to, chain, triangles);
  }
  return true;
}

}  // namespace

ConstrainedTriangles triangles_between(const VectorField<2>& X, const std::vector<Edge>& edges) {
  ConstrainedTriangles result;
  std::vector<Triangle> all = delaunay(X);
  std::set<Edge> present;
  const auto collect = [&] {
    present.clear();
    for (const Triangle& t : all)
      for (std::size_t k = 0; k < 3; ++k) present.insert({t[k], t[(k + 1) % 3]});
  };
  collect();
  for (const Edge& edge : edges) {
    if (present.contains(edge)) continue;
    if (!insert_edge(X, edge, all)) {
      result.failed = edge[0];
      return result;
    }
    collect();
  }

  auto [triangles, missing, open] = enclosed_by(edges, all);
  if (!missing.empty()) result.failed = missing.back()[0];
  if (open >= 0) result.failed = open;
  for (const Triangle& triangle : triangles)
    if (!(triangle_area(X, triangle) > 0.0)) result.failed = triangle[0];
  result.triangles = std::move(triangles);
  return result;
}

std::vector<Cell<2>> paired(const VectorField<2>& X, std::vector<Triangle>& triangles) {
  struct Pair {
    double quality;
    Cell<2> cell;
    std::array<std::size_t, 2> parts;
  };
  std::map<Edge, std::size_t> left;
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& one = triangles[t];
      const int a = one[k], b = one[(k + 1) % 3], c = one[(k + 2) % 3];
      left[{a, b}] = t;
      const auto found = left.find({b, a});
      if (found == left.end()) continue;
      for (const int d : triangles[found->second]) {
        if (d == a || d == b) continue;
        const Cell<2> cell = {a, d, b, c};
        const double quality = cell_quality(X, cell, 0.0);
        if (quality >= least_paired) pairs.push_back({quality, cell, {t, found->second}});
      }
    }
  std::ranges::stable_sort(pairs,
                           [](const Pair& a, const Pair& b) { return a.quality > b.quality; });
  std::vector<char> used(triangles.size(), 0);
  std::vector<Cell<2>> cells;
  for (const Pair& pair : pairs) {
    if (used[pair.parts[0]] || used[pair.parts[1]]) continue;
    used[pair.parts[0]] = used[pair.parts[1]] = 1;
    cells.push_back(pair.cell);
  }
  std::size_t t = 0;
  std::erase_if(triangles, [&](const Triangle&) { return used[t++] != 0; });
  return cells;
}

}  // namespace tlsph

#include "tlsph/filling/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tlsph/geometry/polygon.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

/// Boundary loops of nodes, each face followed to the one that starts where it ends.
std::vector<Corners> loops_of(const VectorField<2>& X, const std::vector<Face<2>>& faces) {
  std::map<int, int> next;
  for (const Face<2>& face : faces) next[face.nodes[0]] = face.nodes[1];
  std::vector<Corners> loops;
  while (!next.empty()) {
    Corners& loop = loops.emplace_back();
    for (auto step = next.begin(); step != next.end();) {
      loop.emplace_back(X.row(step->first).transpose());
      const int node = step->second;
      next.erase(step);
      step = next.find(node);
    }
  }
  return loops;
}

using NodeLists = std::vector<std::vector<int>>;

NodeLists neighbours_of(Index nodes, const std::vector<Triangle>& triangles) {
  NodeLists near(static_cast<std::size_t>(nodes));
  for (const Triangle& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3})
        near[static_cast<std::size_t>(triangle[k])].push_back(triangle[other]);
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return near;
}

/// Nodes whose cells may reach the boundary: those on it and two rings of neighbours.
std::vector<char> near_boundary(const NodeLists& near, const std::vector<Face<2>>& faces) {
  constexpr int rings = 2;
  std::vector<char> mark(near.size(), 0);
  std::vector<int> front;
  for (const Face<2>& face : faces) front.push_back(face.nodes[0]);
  for (const int node : front) mark[static_cast<std::size_t>(node)] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<int> beyond;
    for (const int node : front)
      for (const int other : near[static_cast<std::size_t>(node)])
        if (!std::exchange(mark[static_cast<std::size_t>(other)], 1)) beyond.push_back(other);
    front = std::move(beyond);
  }
  return mark;
}

}  // namespace

ScalarField voronoi_volumes(const VectorField<2>& X, const std::vector<Face<2>>& faces) {
  const Vector<2> lower = X.colwise().minCoeff().transpose();
  const Vector<2> upper = X.colwise().maxCoeff().transpose();
  const Vector<2> margin = upper - lower;
  const Vector<2> a = lower - margin, c = upper + margin;
  const Corners whole = {a, {c.x(), a.y()}, c, {a.x(), c.y()}};

  const NodeLists near = neighbours_of(X.rows(), delaunay(X));
  const std::vector<char> clipped = near_boundary(near, faces);
  const std::vector<Corners> loops = loops_of(X, faces);
  /// The part of the subject that is nearer to node q than to any other.
  const auto nearest_to = [&](Index q, Corners subject) {
    const Vector<2> here = X.row(q).transpose();
    for (const int other : near[static_cast<std::size_t>(q)]) {
      const Vector<2> there = X.row(other).transpose();
      const Vector<2> normal = there - here;
      subject = clip_half_plane(subject, normal, normal.dot(0.5 * (here + there)));
    }
    return signed_area(subject);
  };
  double body = 0.0;
  for (const Corners& loop : loops) body += signed_area(loop);
  ScalarField V = ScalarField::Zero(X.rows());
  const auto measure = [&](const auto& needs_clipping) {
    for (Index q = 0; q < X.rows(); ++q) {
      if (needs_clipping(q)) {
        V[q] = 0.0;
        for (const Corners& loop : loops) V[q] += nearest_to(q, loop);
      } else {
        V[q] = nearest_to(q, whole);
      }
    }
  };
  measure([&](Index q) { return clipped[static_cast<std::size_t>(q)] != 0; });
  // A long face may run through the cell of a node that is no neighbour of its ends.
  if (std::abs(V.sum() - body) > 1e-10 * body) measure([](Index) { return true; });
  return V;
}

}  // namespace tlsph

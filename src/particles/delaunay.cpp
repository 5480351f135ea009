#include "tlsph/particles/delaunay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "tlsph/geometry/polygon.hpp"

namespace tlsph {
namespace {

/// A triangle flatter than this (area over squared longest edge) determines no gradient.
constexpr double flat = 1e-3;

std::uint64_t key(int from, int to) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32U) |
         static_cast<std::uint32_t>(to);
}

/// Triangle to the left of each directed edge.
std::unordered_map<std::uint64_t, int> left_triangles(const std::vector<Triangle>& triangles) {
  std::unordered_map<std::uint64_t, int> left;
  left.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      left.emplace(key(triangles[t][k], triangles[t][(k + 1) % 3]), static_cast<int>(t));
  return left;
}

Vector<2> at(const VectorField<2>& X, int node) {
  return X.row(node).transpose();
}

[[noreturn]] void refuse_face(const VectorField<2>& X, const DirectedEdge& face,
                              const NodePlaces& places) {
  throw InputError(
      places(face[0]),
      fmt::format("too few points on the boundary: between {} and {} others stand closer to it "
                  "than they stand apart, so no triangle has it as its edge; add points there, or "
                  "move those beside it inwards",
                  position_text(at(X, face[0])), position_text(at(X, face[1]))));
}

void check_shapes(const VectorField<2>& X, const std::vector<Triangle>& triangles,
                  const NodePlaces& places) {
  for (const Triangle& triangle : triangles) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      longest =
          std::max(longest, (at(X, triangle[k]) - at(X, triangle[(k + 1) % 3])).squaredNorm());
    if (!(triangle_area(X, triangle) > flat * longest))
      throw InputError(
          places(triangle[0]),
          fmt::format("the points {}, {} and {} stand in a line, so that the triangle between "
                      "them has no area; move one of them",
                      position_text(at(X, triangle[0])), position_text(at(X, triangle[1])),
                      position_text(at(X, triangle[2]))));
  }
}

}  // namespace

std::vector<Triangle> delaunay(const VectorField<2>& X) {
  const Vector<2> lower = X.colwise().minCoeff().transpose();
  const Vector<2> upper = X.colwise().maxCoeff().transpose();
  const double scale = 0x1p30 / (upper - lower).maxCoeff();
  const auto grid = [&](Index q, int a) {
    return static_cast<std::int32_t>(std::lround((X(q, a) - lower[a]) * scale));
  };
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (Index q = 0; q < X.rows(); ++q) builder.insert_point(grid(q, 0), grid(q, 1));
  boost::polygon::voronoi_diagram<double> diagram;
  builder.construct(&diagram);

  std::vector<Triangle> triangles;
  triangles.reserve(2 * static_cast<std::size_t>(X.rows()));
  std::vector<int> around;
  for (const auto& vertex : diagram.vertices()) {
    around.clear();
    const auto* edge = vertex.incident_edge();
    do {
      around.push_back(static_cast<int>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    for (std::size_t k = 2; k < around.size(); ++k) {
      Triangle triangle = {around[0], around[k - 1], around[k]};
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                  triangle.end());
      triangles.push_back(triangle);
    }
  }
  // The sweep's order is that of a diagonal front; rows of operators want that of the nodes.
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

EnclosedTriangles enclosed_by(const std::vector<DirectedEdge>& chains,
                              const std::vector<Triangle>& all) {
  EnclosedTriangles result;
  const auto left = left_triangles(all);
  std::unordered_set<std::uint64_t> walls;
  std::vector<char> inside(all.size(), 0);
  std::vector<std::size_t> front;
  const auto enter = [&](int from, int to) {
    const auto found = left.find(key(from, to));
    if (found == left.end()) return false;
    const auto triangle = static_cast<std::size_t>(found->second);
    if (!std::exchange(inside[triangle], 1)) front.push_back(triangle);
    return true;
  };
  for (const DirectedEdge& edge : chains) {
    walls.insert(key(edge[0], edge[1]));
    if (!enter(edge[0], edge[1])) result.missing.push_back(edge);
  }
  while (!front.empty()) {
    const Triangle triangle = all[front.back()];
    front.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      if (!walls.contains(key(from, to)) && !enter(to, from)) result.open = from;
    }
  }
  for (std::size_t t = 0; t < all.size(); ++t)
    if (inside[t]) result.triangles.push_back(all[t]);
  return result;
}

std::string position_text(const Eigen::Ref<const Eigen::VectorXd>& x) {
  return fmt::format("({:.6g})", fmt::join(x.begin(), x.end(), ", "));
}

std::vector<Triangle> triangulate(const VectorField<2>& X, const std::vector<Face<2>>& faces,
                                  const NodePlaces& places) {
  std::vector<DirectedEdge> chains;
  for (const Face<2>& face : faces) chains.push_back(face.nodes);
  auto [triangles, missing, open] = enclosed_by(chains, delaunay(X));
  if (!missing.empty()) refuse_face(X, missing.front(), places);
  std::vector<char> used(static_cast<std::size_t>(X.rows()), 0);
  for (const Triangle& triangle : triangles)
    for (const int node : triangle) used[static_cast<std::size_t>(node)] = 1;
  check_shapes(X, triangles, places);
  double filled = 0.0;
  for (const Triangle& triangle : triangles) filled += triangle_area(X, triangle);
  double enclosed = 0.0;
  const Vector<2> origin = at(X, 0);
  for (const Face<2>& face : faces) enclosed += 0.5 * face.area.dot(at(X, face.nodes[0]) - origin);
  if (!(std::abs(filled - enclosed) <= 1e-9 * enclosed))
    throw InputError(places(0), fmt::format("the triangles between the points fill {:.9g} m^2, the "
                                            "boundary encloses {:.9g} m^2; the points do not "
                                            "follow the boundary",
                                            filled, enclosed));
  for (Index q = 0; q < X.rows(); ++q)
    if (!used[static_cast<std::size_t>(q)])
      throw InputError(places(q), fmt::format("the point {} is in no triangle of the body",
                                              position_text(X.row(q).transpose())));
  return triangles;
}

double triangle_area(const VectorField<2>& X, const Triangle& triangle) {
  const Vector<2> here = at(X, triangle[0]);
  return 0.5 * cross(at(X, triangle[1]) - here, at(X, triangle[2]) - here);
}

Vector<2> triangle_centre(const VectorField<2>& X, const Triangle& triangle) {
  return (at(X, triangle[0]) + at(X, triangle[1]) + at(X, triangle[2])) / 3.0;
}

std::vector<TriangleEdge> edges_of(const std::vector<Triangle>& triangles) {
  const auto left = left_triangles(triangles);
  std::vector<TriangleEdge> edges;
  edges.reserve(3 * triangles.size() / 2);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      TriangleEdge edge = {triangles[t][k], triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3]};
      const auto other = left.find(key(edge.b, edge.a));
      if (other != left.end()) {
        if (other->second < static_cast<int>(t)) continue;
        for (const int node : triangles[static_cast<std::size_t>(other->second)])
          if (node != edge.a && node != edge.b) edge.right = node;
      }
      edges.push_back(edge);
    }
  return edges;
}

}  // namespace tlsph

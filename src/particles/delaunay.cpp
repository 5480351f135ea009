#include "tlsph/particles/delaunay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <unordered_map>

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

std::string point(const Vector<2>& x) {
  return fmt::format("({:.6g}, {:.6g})", x.x(), x.y());
}

[[noreturn]] void refuse_face(const VectorField<2>& X, const Face<2>& face,
                              const NodePlaces& places) {
  throw InputError(
      places(face.nodes[0]),
      fmt::format("too few points on the boundary: between {} and {} others stand closer to it "
                  "than they stand apart, so no triangle has it as its edge; add points there, or "
                  "move those beside it inwards",
                  point(at(X, face.nodes[0])), point(at(X, face.nodes[1]))));
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
                      point(at(X, triangle[0])), point(at(X, triangle[1])),
                      point(at(X, triangle[2]))));
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

std::vector<Triangle> triangulate(const VectorField<2>& X, const std::vector<Face<2>>& faces,
                                  const NodePlaces& places) {
  const std::vector<Triangle> all = delaunay(X);
  const auto left = left_triangles(all);
  std::unordered_map<std::uint64_t, int> walls;
  std::vector<char> inside(all.size(), 0);
  std::vector<int> front;
  const auto enter = [&](int triangle) {
    if (inside[static_cast<std::size_t>(triangle)]) return;
    inside[static_cast<std::size_t>(triangle)] = 1;
    front.push_back(triangle);
  };
  for (const Face<2>& face : faces) {
    const auto found = left.find(key(face.nodes[0], face.nodes[1]));
    if (found == left.end()) refuse_face(X, face, places);
    walls.emplace(found->first, found->second);
    enter(found->second);
  }
  while (!front.empty()) {
    const Triangle triangle = all[static_cast<std::size_t>(front.back())];
    front.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      if (walls.contains(key(from, to))) continue;
      const auto beyond = left.find(key(to, from));
      if (beyond != left.end()) enter(beyond->second);
    }
  }
  std::vector<Triangle> triangles;
  std::vector<char> used(static_cast<std::size_t>(X.rows()), 0);
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (!inside[t]) continue;
    triangles.push_back(all[t]);
    for (const int node : all[t]) used[static_cast<std::size_t>(node)] = 1;
  }
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
                                              point(X.row(q).transpose())));
  return triangles;
}

double triangle_area(const VectorField<2>& X, const Triangle& triangle) {
  const Vector<2> u = at(X, triangle[1]) - at(X, triangle[0]);
  const Vector<2> v = at(X, triangle[2]) - at(X, triangle[0]);
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
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

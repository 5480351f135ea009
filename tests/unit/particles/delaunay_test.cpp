#include "tlsph/particles/delaunay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/particles/boundary_faces.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Nodes row by row.
VectorField<2> nodes(const std::vector<Vector<2>>& points) {
  VectorField<2> X(static_cast<Index>(points.size()), 2);
  for (std::size_t q = 0; q < points.size(); ++q) X.row(static_cast<Index>(q)) = points[q];
  return X;
}

/// Faces from node to node once around.
std::vector<Face<2>> around(const VectorField<2>& X, const std::vector<int>& loop) {
  std::vector<Face<2>> faces;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int from = loop[k], to = loop[(k + 1) % loop.size()];
    faces.push_back({{from, to}, face_area(X.row(from).transpose(), X.row(to).transpose())});
  }
  return faces;
}

Place csv_line_of(Index q) {
  return {"p.csv", static_cast<int>(q) + 2, 1, ""};
}

TEST(Delaunay, TakesTheShorterDiagonal) {
  const auto X = nodes({{0, 0}, {2, 0}, {2.5, 1}, {0.5, 1}});
  EXPECT_THAT(delaunay(X), ElementsAre(Triangle{0, 1, 3}, Triangle{1, 2, 3}));
}

TEST(Delaunay, CutsSquaresOfALatticeOnce) {
  std::vector<Vector<2>> points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 30; ++j) points.emplace_back(0.1 * i, 0.1 * j);
  const auto X = nodes(points);

  const auto triangles = delaunay(X);

  EXPECT_EQ(triangles.size(), 2u * 19 * 29);
  for (const Triangle& triangle : triangles) EXPECT_NEAR(triangle_area(X, triangle), 0.005, 1e-12);
}

/// The defining property, on nodes in no order: no node within the circle around a triangle.
TEST(Delaunay, CirclesAroundTrianglesAreEmpty) {
  std::vector<Vector<2>> points;
  for (int k = 1; k <= 150; ++k)
    points.emplace_back(std::fmod(0.754877666 * k, 1.0), std::fmod(0.569840291 * k, 1.0));
  const auto X = nodes(points);

  for (const Triangle& t : delaunay(X)) {
    // Three nodes in a line along the hull: flat but for rounding.
    if (std::abs(triangle_area(X, t)) < 1e-12) continue;
    EXPECT_GT(triangle_area(X, t), 0.0);
    const Vector<2> a = points[t[0]], b = points[t[1]] - a, c = points[t[2]] - a;
    const double twice = 2.0 * (b.x() * c.y() - b.y() * c.x());
    const Vector<2> arm = Vector<2>(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                                    b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                          twice;
    for (const auto& point : points) ASSERT_GE((point - a - arm).norm(), arm.norm() - 1e-8);
  }
}

/// A square ring: the hole's own triangles are left out, and so are those across a notch.
TEST(Triangulate, FillsTheBodyOnly) {
  const auto X = nodes({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}});
  auto faces = around(X, {0, 1, 2, 3});
  const auto hole = around(X, {4, 7, 6, 5});
  faces.insert(faces.end(), hole.begin(), hole.end());

  const auto triangles = triangulate(X, faces, csv_line_of);

  EXPECT_EQ(triangles.size(), 8u);
  double sum = 0.0;
  for (const Triangle& triangle : triangles) sum += triangle_area(X, triangle);
  EXPECT_NEAR(sum, 8.0, 1e-12);

  const auto L = nodes({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  EXPECT_EQ(triangulate(L, around(L, {0, 1, 2, 3, 4, 5}), csv_line_of).size(), 4u);
}

TEST(Triangulate, RefusesAFaceWithANodeTooClose) {
  const auto X = nodes({{0, 0}, {4, 0}, {4, 1}, {0, 1}, {2, 0.1}, {2, -1}});
  EXPECT_THAT(refusal([&] {
                (void)triangulate(X, around(X, {0, 1, 2, 3}), csv_line_of);
              }),
              HasSubstr("p.csv:2:1: too few points on the boundary: between (0, 0) and (4, 0)"));
}

TEST(Triangulate, RefusesTrianglesWithoutArea) {
  const auto X = nodes({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 1e-5}});
  EXPECT_THAT(refusal([&] {
                (void)triangulate(X, around(X, {0, 1, 2, 3}), csv_line_of);
              }),
              HasSubstr("stand in a line"));
}

TEST(EdgesOf, TwoTrianglesAreFive) {
  const auto edges = edges_of({{0, 1, 3}, {1, 2, 3}});
  ASSERT_EQ(edges.size(), 5u);
  int inner = 0;
  for (const auto& edge : edges) {
    if (edge.right < 0) continue;
    ++inner;
    EXPECT_THAT((std::vector{edge.a, edge.b, edge.left, edge.right}), ElementsAre(1, 3, 0, 2));
  }
  EXPECT_EQ(inner, 1);
}

}  // namespace
}  // namespace tlsph

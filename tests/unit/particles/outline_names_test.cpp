/// What edges are called: by what they face, by number, by hole.

#include "tlsph/particles/boundary_faces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// The names of the edges by number, "-" for one that has none.
std::vector<std::string> sides(const Shape<2>& shape) {
  std::vector<std::string> names;
  const OutlineNames outline(shape);
  for (const NamedPiece& named : outline.pieces()) {
    const auto edge = static_cast<std::size_t>(named.edge);
    if (names.size() < edge) names.resize(edge, "-");
    if (named.side != no_side) names[edge - 1] = side_names[static_cast<std::size_t>(named.side)];
  }
  return names;
}

using testing::ElementsAre;

TEST(OutlineNames, NumbersTheEdgesInTheOrderOfTheShape) {
  EXPECT_THAT(sides(make_box<2>({0, 0}, {2, 1})), ElementsAre("bottom", "right", "top", "left"));
  EXPECT_THAT(sides(make_polygon({{2, 1}, {2, 0}, {0, 0}, {0, 1}})),
              ElementsAre("right", "bottom", "left", "top"));
  EXPECT_THAT(sides(make_disc({0, 0}, 1.0)), ElementsAre("-"));
  // A hole within the body has no sides, though its walls face all ways.
  EXPECT_THAT(sides(make_difference(make_box<2>({0, 0}, {3, 3}), {make_box<2>({1, 1}, {2, 2})})),
              ElementsAre("bottom", "right", "top", "left", "-", "-", "-", "-"));
}

TEST(OutlineNames, AreThoseOfTheOutermostEdgesThatFaceAWay) {
  // An L: its inner edges face right and up too, but lie behind.
  EXPECT_THAT(sides(make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})),
              ElementsAre("bottom", "right", "-", "-", "top", "left"));
  // A tooth that sticks out of the left edge has no edge that faces left.
  EXPECT_THAT(sides(make_polygon({{0, 0}, {1, 0}, {1, 3}, {0, 3}, {0, 2}, {-1, 1.5}, {0, 1}})),
              ElementsAre("bottom", "right", "top", "left", "-", "-", "left"));
  // Slanted edges face none of the four ways.
  EXPECT_THAT(sides(make_polygon({{0, 0}, {4.8, 4.4}, {4.8, 6.0}, {0, 4.4}})),
              ElementsAre("-", "right", "-", "left"));
}

/// A quarter of a ring, cut out in any of four ways by boxes.
Shape<2> quarter_ring(double sx, double sy) {
  const auto beside = [](double x0, double y0, double x1, double y1) {
    return make_box<2>({std::min(x0, x1), std::min(y0, y1)}, {std::max(x0, x1), std::max(y0, y1)});
  };
  return make_difference(
      make_disc({0, 0}, 1.0),
      {make_disc({0, 0}, 0.6), beside(-1.2 * sx, -1.2, 0, 1.2), beside(-1.2, -1.2 * sy, 1.2, 0)});
}

/// Every filling names the same parts of a quarter ring.
TEST(OutlineNames, OfAQuarterRingAreThoseOfItsStraightEdges) {
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0}) {
      const Shape<2> shape = quarter_ring(sx, sy);
      const auto lattice = make_lattice(shape, 0.05);
      for (const auto& body : {lattice, fitted(lattice, shape), hexagonal_lattice(shape, 0.05)}) {
        const char* across = sx > 0 ? "left" : "right";
        const char* along = sy > 0 ? "bottom" : "top";
        for (const char* name : {across, along}) {
          ASSERT_NE(body.find(name), nullptr) << name;
          EXPECT_NEAR(patch_extent(*body.find(name)), 0.4, 1e-12);
          const int axis = name == across ? 0 : 1;
          for (const int node : body.find(name)->nodes) EXPECT_NEAR(body.X(node, axis), 0.0, 1e-12);
        }
        EXPECT_EQ(body.find(sx > 0 ? "right" : "left") != nullptr, body.cells == lattice.cells);
        // What is left to `hole` is the bore; by number the boxes keep what they leave.
        EXPECT_EQ(body.find("hole")->faces.size(), body.find("hole1")->faces.size());
        EXPECT_EQ(body.find("hole2")->nodes, body.find(across)->nodes);
        EXPECT_EQ(body.find("hole3")->nodes, body.find(along)->nodes);
        ASSERT_EQ(body.edges.size(), 4U);
        std::size_t faces = 0;
        for (const Patch<2>& edge : body.edges) faces += edge.faces.size();
        EXPECT_EQ(faces, body.find("boundary")->faces.size());
        EXPECT_EQ(body.find("edge3")->nodes, body.find(across)->nodes);
        EXPECT_EQ(body.find("edge4")->nodes, body.find(along)->nodes);
      }
    }
}

TEST(OutlineNames, KeepASmoothJointWithinOneEdge) {
  // A polygon of 36 corners turns by 10° at each.
  std::vector<Vector<2>> corners;
  for (int k = 0; k < 36; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 36;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  EXPECT_THAT(sides(make_polygon(corners)), testing::SizeIs(1));
}

}  // namespace
}  // namespace tlsph

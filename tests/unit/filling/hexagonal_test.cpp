#include "tlsph/filling/lattice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "boundary_distance.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

/// 4 spacings by 2 rows: 5 + 6 + 5 nodes.
TEST(Hexagonal, BoxByHand) {
  const double height = std::sqrt(3.0);
  const auto body = hexagonal_lattice(make_box<2>({0, 0}, {4, height}), 1.0);

  ASSERT_EQ(body.size(), 16);
  EXPECT_NEAR(body.spacing, 1.0, 1e-12);
  std::vector<double> middle;
  for (Index q = 0; q < body.size(); ++q)
    if (std::abs(body.X(q, 1) - 0.5 * height) < 1e-9) middle.push_back(body.X(q, 0));
  std::sort(middle.begin(), middle.end());
  EXPECT_THAT(middle,
              testing::Pointwise(testing::DoubleNear(1e-12), {0.0, 0.5, 1.5, 2.5, 3.5, 4.0}));
  EXPECT_EQ(body.find("left")->nodes.size(), 3u);
  EXPECT_EQ(body.find("bottom")->nodes.size(), 5u);
  EXPECT_NEAR(body.V.sum(), 4.0 * height, 1e-13);
  // An inner node owns a whole hexagon, √3/2 Δ².
  EXPECT_NEAR(body.V.maxCoeff(), 0.5 * height, 1e-12);
}

struct HexagonalCase {
  const char* name;
  Shape<2> shape;
};

class Hexagonal : public testing::TestWithParam<HexagonalCase> {};

TEST_P(Hexagonal, FollowsTheBoundaryAndFillsTheBody) {
  const Shape<2>& shape = GetParam().shape;
  for (const double spacing : {0.1, 0.05}) {
    const auto body = hexagonal_lattice(shape, spacing);
    const auto& outer = body.find("boundary")->nodes;
    for (int q = 0; q < static_cast<int>(body.size()); ++q) {
      const double distance = signed_distance(shape, Vector<2>(body.X.row(q).transpose()));
      if (std::binary_search(outer.begin(), outer.end(), q))
        EXPECT_NEAR(distance, 0.0, 1e-12);
      else
        EXPECT_GT(distance, 0.4 * spacing);
    }
    EXPECT_NEAR(body.V.sum(), area(shape), 0.2 * boundary_measure(shape) * spacing * spacing);
    EXPECT_GT(body.V.minCoeff(), 0.1 * spacing * spacing);
    EXPECT_LT(body.V.maxCoeff(), 1.4 * spacing * spacing);
    double filled = 0.0;
    for (const Triangle& triangle : body.triangles) filled += triangle_area(body.X, triangle);
    EXPECT_NEAR(filled, body.V.sum(), 1e-12);
    EXPECT_NEAR((body.B.transpose() * body.X - filled * Tensor<2>::Identity()).norm(), 0.0, 1e-12);
  }
}

TEST_P(Hexagonal, MostInnerNodesHaveSixNeighbours) {
  const auto body = hexagonal_lattice(GetParam().shape, 0.05);
  std::vector<int> ends(static_cast<std::size_t>(body.size()), 0);
  for (const auto& edge : edges_of(body.triangles))
    for (const int node : {edge.a, edge.b}) ++ends[static_cast<std::size_t>(node)];
  const auto& outer = body.find("boundary")->nodes;
  int inner = 0, six = 0;
  for (int q = 0; q < static_cast<int>(body.size()); ++q) {
    if (std::binary_search(outer.begin(), outer.end(), q)) continue;
    ++inner;
    six += ends[static_cast<std::size_t>(q)] == 6;
  }
  EXPECT_GT(six, 0.8 * inner);
}

TEST_P(Hexagonal, JitterKeepsBoundaryAndTriangles) {
  const auto lattice = hexagonal_lattice(GetParam().shape, 0.05);

  const auto body = jittered(lattice, 0.4, 3);

  const auto& outer = body.find("boundary")->nodes;
  double moved = 0.0;
  for (int q = 0; q < static_cast<int>(body.size()); ++q) {
    const double distance = (body.X.row(q) - lattice.X.row(q)).norm();
    moved = std::max(moved, distance);
    EXPECT_TRUE(distance == 0.0 || !std::binary_search(outer.begin(), outer.end(), q));
  }
  EXPECT_GT(moved, 0.3 * 0.05);
  EXPECT_LE(moved, 0.4 * std::sqrt(2.0) * body.spacing * (1.0 + 1e-12));
  for (const Triangle& triangle : body.triangles) EXPECT_GT(triangle_area(body.X, triangle), 0.0);
  EXPECT_NEAR(body.V.sum(), lattice.V.sum(), 1e-12);
  EXPECT_GT(body.V.minCoeff(), 0.0);
  EXPECT_EQ(jittered(lattice, 0.4, 3).X, body.X);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Hexagonal,
    testing::Values(
        HexagonalCase{"box", make_box<2>({0, 0}, {2, 1})},
        HexagonalCase{"disc", make_disc({0, 0}, 1.0)},
        HexagonalCase{"quarter",
                      make_difference(make_box<2>({0, 0}, {1, 1}), {make_disc({0, 0}, 0.4)})},
        HexagonalCase{"hole",
                      make_difference(make_box<2>({0, 0}, {2, 2}), {make_disc({1.03, 0.98}, 0.5)})},
        HexagonalCase{"ring", make_difference(make_disc({0, 0}, 1.0), {make_disc({0, 0}, 0.5)})},
        HexagonalCase{"triangle", make_polygon({{0, 0}, {2, 0}, {0.7, 1.6}})},
        HexagonalCase{"bite",
                      make_difference(make_box<2>({0, 0}, {2, 1}), {make_disc({1, -0.3}, 0.6)})},
        HexagonalCase{"corner", make_polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(HexagonalRefusals, NamePlaceAndRemedy) {
  const Place place{"a.toml", 4, 11, "body.spacing"};
  EXPECT_THAT(refusal([&] {
                (void)hexagonal_lattice(make_box<2>({0, 0}, {1, 1}), 0.3, place);
              }),
              HasSubstr("a.toml:4:11: body.spacing: spacing 0.3 does not divide the body"));
  const Shape<2> pierced =
      make_difference(make_box<2>({0, 0}, {1, 1}), {make_disc({0.5, 0.5}, 0.01)});
  EXPECT_THAT(refusal([&] { (void)hexagonal_lattice(pierced, 0.1, place); }),
              HasSubstr("too coarse for the edge of length"));
}

}  // namespace
}  // namespace tlsph

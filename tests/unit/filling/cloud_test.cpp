#include "tlsph/filling/cloud.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/points.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Points = std::vector<Vector<2>>;

Place line_of(Index q) {
  return {"p.csv", static_cast<int>(q) + 2, 1, ""};
}

VectorField<2> field(const Points& points) {
  VectorField<2> X(static_cast<Index>(points.size()), 2);
  for (std::size_t q = 0; q < points.size(); ++q) X.row(static_cast<Index>(q)) = points[q];
  return X;
}

Particles<2> cloud(const Points& points, const Shape<2>& shape, double spacing = 0.0) {
  return make_cloud<2>(field(points), shape, spacing, line_of);
}

const Shape<2> square = make_box<2>({0, 0}, {2, 2});
/// Corners and middle, the middle first.
const Points five = {{1, 1}, {0, 0}, {2, 0}, {2, 2}, {0, 2}};

TEST(Cloud, OfFiveNodesByHand) {
  const auto body = cloud(five, square);

  EXPECT_EQ(body.triangles.size(), 4u);
  EXPECT_TRUE(body.cells.empty());
  EXPECT_FALSE(body.frame);
  // The cell of the middle is the diamond through the middles of the edges.
  EXPECT_NEAR((body.V - ScalarField{{2.0, 0.5, 0.5, 0.5, 0.5}}).norm(), 0.0, 1e-14);
  EXPECT_THAT(body.find("bottom")->nodes, ElementsAre(1, 2));
  EXPECT_THAT(body.find("left")->nodes, ElementsAre(1, 4));
  EXPECT_EQ(body.find("boundary")->faces.size(), 4u);
  EXPECT_NEAR((body.B.row(3) - Eigen::RowVector2d(1.0, 1.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(body.B.row(0).norm(), 0.0, 1e-15);
  // Pick: 5 nodes, 4 of them on the boundary, make two cells of area two.
  EXPECT_NEAR(body.spacing, std::sqrt(2.0), 1e-15);
}

TEST(Cloud, StressPointsStandOnTheEdges) {
  const auto points = cell_points(cloud(five, square));

  ASSERT_EQ(points.size(), 8);
  EXPECT_NEAR(points.V.sum(), 4.0, 1e-14);
  EXPECT_NEAR((points.X.transpose() * points.V - Vector<2>(4.0, 4.0)).norm(), 0.0, 1e-14);
  for (Index s = 0; s < points.size(); ++s) {
    const bool outer = std::abs(points.V[s] - 1.0 / 3.0) < 1e-14;
    EXPECT_NEAR(points.V[s], outer ? 1.0 / 3.0 : 2.0 / 3.0, 1e-14);
  }
}

TEST(Cloud, PutsNodesNearTheOutlineOntoIt) {
  Points points = five;
  points.push_back({1.0, 3e-4});
  points[1] = {-2e-4, 1e-4};

  const auto body = cloud(points, square, 1.0);

  EXPECT_EQ(body.X(5, 1), 0.0);
  EXPECT_NEAR(body.X.row(1).norm(), 0.0, 0.0);
  EXPECT_THAT(body.find("bottom")->nodes, ElementsAre(1, 2, 5));
  EXPECT_EQ(body.spacing, 1.0);
}

/// Eight nodes on each circle of a ring and eight between.
Points ring_of_nodes() {
  Points points;
  for (const double radius : {1.0, 1.5, 2.0})
    for (int k = 0; k < 16; ++k) {
      const double angle = std::acos(-1.0) * (k + (radius == 1.5 ? 0.5 : 0.0)) / 8.0;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  return points;
}

TEST(Cloud, OfARingKnowsItsHole) {
  const Shape<2> ring = make_difference(make_disc({0, 0}, 2.0), {make_disc({0, 0}, 1.0)});
  const auto body = cloud(ring_of_nodes(), ring);

  EXPECT_EQ(body.find("hole")->faces.size(), 16u);
  EXPECT_EQ(body.find("outer")->faces.size(), 16u);
  const double polygons = 8.0 * std::sin(std::acos(-1.0) / 8.0) * (4.0 - 1.0);
  EXPECT_NEAR(body.V.sum(), polygons, 1e-13);
  EXPECT_NEAR(body.B.colwise().sum().norm(), 0.0, 1e-13);
  const Tensor<2> first = body.B.transpose() * body.X;
  EXPECT_NEAR((first - polygons * Tensor<2>::Identity()).norm(), 0.0, 1e-12);
  for (Index q = 1; q < 16; ++q) EXPECT_NEAR(body.V[q], body.V[0], 1e-14);
}

/// Nodes of the one arm of an L are closer to the other than its own: areas still sum up.
TEST(Voronoi, FillsBodiesThatAreNotConvex) {
  const Points corners = {{0, 0}, {3, 0}, {3, 1}, {0.2, 1}, {0.2, 1.1}, {3, 1.1}, {3, 2}, {0, 2}};
  VectorField<2> X = field(corners);
  std::vector<Face<2>> faces;
  for (int k = 0; k < 8; ++k) faces.push_back({{k, (k + 1) % 8}, Vector<2>::Zero()});

  const ScalarField V = voronoi_volumes(X, faces);

  EXPECT_NEAR(V.sum(), 6.0 - 0.28, 1e-13);
  EXPECT_GT(V.minCoeff(), 0.0);
}

TEST(Cloud, InOneDimensionByHand) {
  VectorField<1> X(4, 1);
  X << 3.0, 0.0, 1.0, 7.0;

  const auto body = make_cloud<1>(X, make_interval(0.0, 7.0), 0.0, line_of);

  EXPECT_NEAR((body.V - ScalarField{{3.0, 0.5, 1.5, 2.0}}).norm(), 0.0, 1e-15);
  EXPECT_THAT(body.cells, ElementsAre(Cell<1>{1, 2}, Cell<1>{2, 0}, Cell<1>{0, 3}));
  EXPECT_THAT(body.find("left")->nodes, ElementsAre(1));
  EXPECT_THAT(body.find("right")->nodes, ElementsAre(3));
  EXPECT_NEAR(body.spacing, 7.0 / 3.0, 1e-15);
}

TEST(CloudVolumes, AreTakenIfTheyFillTheBody) {
  const auto body = cloud(five, square);
  const ScalarField own{{1.0, 0.75, 0.75, 0.75, 0.76}};

  EXPECT_EQ(with_volumes<2>(body, own, square, line_of).V, own);
  EXPECT_THAT(refusal([&] { (void)with_volumes<2>(body, 2.0 * own, square, line_of); }),
              HasSubstr("the volumes sum to 8.02, but the shape has 4"));
  const ScalarField empty{{2.0, 0.0, 1.0, 0.5, 0.5}};
  EXPECT_THAT(refusal([&] { (void)with_volumes<2>(body, empty, square, line_of); }),
              HasSubstr("p.csv:3:1: a volume must be greater than 0"));
}

TEST(CloudTags, HoldTheFacesBetweenTheirNodes) {
  const auto body = with_named_nodes<2>(cloud(five, square), "grip", {4, 1, 2, 4}, {});

  const Patch<2>* grip = body.find("grip");
  ASSERT_NE(grip, nullptr);
  EXPECT_THAT(grip->nodes, ElementsAre(1, 2, 4));
  EXPECT_EQ(grip->faces.size(), 2u);
  EXPECT_THAT(refusal([&] { (void)with_named_nodes<2>(body, "left", {0}, line_of(3)); }),
              HasSubstr("p.csv:5:1: tag \"left\" already names"));
}

struct BadCloud {
  const char* name;
  Points points;
  const char* message;
};

class BadClouds : public testing::TestWithParam<BadCloud> {};

TEST_P(BadClouds, NameTheNodeToBlame) {
  EXPECT_THAT(refusal([&] { (void)cloud(GetParam().points, square); }),
              HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BadClouds,
    testing::Values(BadCloud{"Outside",
                             {{1, 1}, {0, 0}, {2, 0}, {2, 2}, {0, 2}, {2.5, 1}},
                             "p.csv:7:1: the point (2.5, 1) lies outside the shape, 0.5 m from it"},
                    BadCloud{"Twice",
                             {{1, 1}, {0, 0}, {2, 0}, {2, 2}, {0, 2}, {2, 0}},
                             "p.csv:7:1: the point (2, 0) stands where (2, 0) does, on line 4"},
                    BadCloud{"NoCorner",
                             {{1, 1}, {0, 0}, {2, 0}, {2, 1.8}, {1.8, 2}, {0, 2}},
                             "the shape has a corner at (2, 2), the nearest point is"},
                    BadCloud{"TwoNodes", {{0, 0}, {2, 2}}, "at least three points"},
                    BadCloud{"BareBoundary",
                             {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0.1}, {1, 1.9}},
                             "too few points on the boundary"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BadLines, NameTheNodeToBlame) {
  const auto message = [](std::initializer_list<double> x) {
    VectorField<1> X(static_cast<Index>(x.size()), 1);
    std::copy(x.begin(), x.end(), X.data());
    return refusal([&] { (void)make_cloud<1>(X, make_interval(0.0, 1.0), 0.0, line_of); });
  };
  EXPECT_THAT(message({0.0}), HasSubstr("at least two points"));
  EXPECT_THAT(message({0.0, 0.5}), HasSubstr("p.csv:3:1: the shape ends at 1, the nearest point"));
  EXPECT_THAT(message({0.0, 0.5, 1.0, 1.5}), HasSubstr("p.csv:5:1: the point (1.5) lies outside"));
  EXPECT_THAT(message({0.0, 0.5, 1.0, 0.5}), HasSubstr("p.csv:5:1: the point (0.5) stands where"));
}

}  // namespace
}  // namespace tlsph

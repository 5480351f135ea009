/// Runs of boundary faces between corners, and nodes that integrate along them.

#include "tlsph/particles/boundary_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"

namespace tlsph {
namespace {

constexpr double pi = std::numbers::pi;

/// A circle of that radius through unevenly spaced nodes, the body inside.
struct Circle {
  VectorField<2> X;
  std::vector<Face<2>> faces;

  Circle(double radius, int nodes) : X(nodes, 2) {
    for (int q = 0; q < nodes; ++q) {
      const double angle = 2 * pi * (q + 0.15 * std::sin(2 * pi * q / nodes)) / nodes;
      X.row(q) << radius * std::cos(angle), radius * std::sin(angle);
    }
    for (int q = 0; q < nodes; ++q) {
      const int next = (q + 1) % nodes;
      faces.push_back({{q, next}, face_area(X.row(q).transpose(), X.row(next).transpose())});
    }
  }
};

TEST(BoundaryRuns, OfABoxAreItsSides) {
  const auto body =
      make_lattice<2>(make_box<2>({0.0, 0.0}, {0.6, 0.4}), 0.1, NodePlacement::on_boundary);

  const auto runs = boundary_runs(body.X, body.find("boundary")->faces);

  ASSERT_EQ(runs.size(), 4U);
  std::size_t faces = 0;
  for (const BoundaryRun& run : runs) {
    faces += run.face.size();
    EXPECT_FALSE(run.closed);
    EXPECT_EQ(run.node.size(), run.face.size() + 1);
    for (std::size_t k = 0; k < run.face.size(); ++k) EXPECT_EQ(run.arc(k), run.chord[k]);
  }
  EXPECT_EQ(faces, body.find("boundary")->faces.size());
}

TEST(BoundaryRuns, OfACircleIsOneThatKnowsItsArcs) {
  const Circle circle(0.5, 40);

  const auto runs = boundary_runs(circle.X, circle.faces);

  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].closed);
  EXPECT_EQ(runs[0].node.size(), 40U);
  double length = 0.0, chords = 0.0;
  for (std::size_t k = 0; k < 40; ++k) {
    length += runs[0].arc(k);
    chords += runs[0].chord[k];
  }
  EXPECT_NEAR(length, pi, 2e-5);
  EXPECT_GE(pi - chords, 2e-3);
}

TEST(CubicShares, IntegrateCubicsAlongAStraightEdge) {
  const auto body =
      make_lattice<2>(make_box<2>({0.0, 0.0}, {1.0, 0.5}), 0.125, NodePlacement::on_boundary);
  std::vector<Face<2>> faces = body.find("top")->faces;

  make_shares_cubic(body.X, faces);

  const VectorField<2> B = lumped_areas<2>(body.size(), faces);
  for (const int degree : {0, 1, 2, 3})
    EXPECT_NEAR(B.col(1).dot(body.X.col(0).array().pow(degree).matrix()), 1.0 / (degree + 1), 1e-14)
        << degree;
  EXPECT_EQ(B.col(0).cwiseAbs().maxCoeff(), 0.0);
}

/// ∮ n f dA with f = x + x³y: order four, where the trapezoidal rule on chords has two.
TEST(CubicShares, IntegrateAlongACurveWithOrderFour) {
  const auto error = [](int nodes) {
    Circle circle(1.0, nodes);
    make_shares_cubic(circle.X, circle.faces);
    const VectorField<2> B = lumped_areas<2>(circle.X.rows(), circle.faces);
    const Eigen::ArrayXd x = circle.X.col(0).array(), y = circle.X.col(1).array();
    const Vector<2> sum = B.transpose() * (x + x.cube() * y).matrix();
    // ∫ ∇f over the disc: ∂x = 1 + 3x²y, ∂y = x³.
    return (sum - Vector<2>(pi, 0.0)).norm();
  };

  const double coarse = error(32), fine = error(64);

  EXPECT_LE(fine, 1e-4);
  EXPECT_GE(std::log2(coarse / fine), 3.5);
}

TEST(CubicShares, GiveAreaVectorsAlongTheNormal) {
  Circle circle(1.0, 48);

  make_shares_cubic(circle.X, circle.faces);

  const VectorField<2> B = lumped_areas<2>(48, circle.faces);
  for (Index q = 0; q < 48; ++q) {
    const double across = B(q, 0) * circle.X(q, 1) - B(q, 1) * circle.X(q, 0);
    EXPECT_LE(std::abs(across), 2e-4 * B.row(q).norm()) << q;
  }
}

}  // namespace
}  // namespace tlsph

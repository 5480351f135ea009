/// Node volumes that integrate quadratics, each neighbourhood by itself.

#include "tlsph/operators/local_volumes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

Particles<2> square(int cells, double jitter) {
  const Shape<2> shape = make_box<2>({0.0, 0.0}, {1.0, 1.0});
  return jittered<2>(make_lattice<2>(shape, 1.0 / cells, NodePlacement::on_boundary), jitter, 3);
}

TEST(LocalVolumes, IntegrateQuadraticsOverIrregularCells) {
  const Particles<2> body = square(12, 0.2);

  const ScalarField V = local_volumes<2>(body);

  EXPECT_GT(V.minCoeff(), 0.0);
  for (const auto& [i, j] : monomials<2>(2)) {
    double sum = 0.0;
    for (Index q = 0; q < body.size(); ++q)
      sum += V[q] * std::pow(body.X(q, 0), i) * std::pow(body.X(q, 1), j);
    EXPECT_NEAR(sum, 1.0 / ((i + 1) * (j + 1)), 1e-13) << i << j;
  }
}

TEST(LocalVolumes, IntegrateQuadraticsOverTriangles) {
  const Particles<2> body = hexagonal_lattice(make_box<2>({0.0, 0.0}, {1.0, 1.0}), 0.1);
  ASSERT_TRUE(body.cells.empty());

  const ScalarField V = local_volumes<2>(body);

  for (const auto& [i, j] : monomials<2>(2)) {
    double sum = 0.0;
    for (Index q = 0; q < body.size(); ++q)
      sum += V[q] * std::pow(body.X(q, 0), i) * std::pow(body.X(q, 1), j);
    EXPECT_NEAR(sum, 1.0 / ((i + 1) * (j + 1)), 1e-13) << i << j;
  }
}

TEST(LocalVolumes, IntegrateQuadraticsOverAnInterval) {
  const Particles<1> bar = jittered<1>(
      make_lattice<1>(make_interval(0.0, 2.0), 0.1, NodePlacement::on_boundary), 0.3, 5);

  const ScalarField V = local_volumes<1>(bar);

  EXPECT_NEAR(V.sum(), 2.0, 1e-14);
  EXPECT_NEAR(V.dot(bar.X.col(0)), 2.0, 1e-14);
  EXPECT_NEAR(V.dot(bar.X.col(0).cwiseAbs2()), 8.0 / 3.0, 1e-13);
}

/// Far from the boundary nothing is left to correct, however coarse the lattice.
TEST(LocalVolumes, AreThoseOfTheCellsInsideALattice) {
  for (const int cells : {16, 32}) {
    const Particles<2> body = square(cells, 0.0);

    const ScalarField V = local_volumes<2>(body);

    for (Index q = 0; q < body.size(); ++q) {
      const Vector<2> X = body.X.row(q).transpose();
      const double depth = std::min({X.x(), X.y(), 1 - X.x(), 1 - X.y()}) * cells;
      if (depth > 4.0) {
        EXPECT_NEAR(V[q] * cells * cells, 1.0, 1e-13) << X.transpose();
      }
    }
  }
}

/// Segments between chords and arcs count: what is left falls as the fourth power of the spacing.
TEST(LocalVolumes, FollowACurvedBoundary) {
  const Shape<2> shape = make_difference(make_disc({0.0, 0.0}, 1.0), {make_disc({0.2, 0.1}, 0.3)});
  const double area = std::numbers::pi * (1.0 - 0.09);
  for (const double spacing : {0.1, 0.05}) {
    const Particles<2> body =
        fitted(make_lattice<2>(shape, spacing, NodePlacement::on_boundary), shape);

    const ScalarField V = local_volumes<2>(body);

    EXPECT_GE(std::abs(body.V.sum() - area), 3e-2 * spacing * spacing) << "of the polygon";
    EXPECT_LE(std::abs(V.sum() - area), 2e-3 * spacing * spacing);
    EXPECT_GT(V.minCoeff(), 0.0);
  }
}

/// Corners of 27°, 63° and 90°: what bounds take from one node its neighbours make good.
TEST(LocalVolumes, StayNearTheirShareOfTheCellsAtSharpCorners) {
  constexpr double a = 2.0, b = 1.0;
  const Shape<2> shape = make_polygon({{0.0, 0.0}, {a, 0.0}, {0.0, b}});
  const Particles<2> body = fitted(make_lattice<2>(shape, 0.1, NodePlacement::on_boundary), shape);

  const ScalarField V = local_volumes<2>(body);

  EXPECT_GE(V.cwiseQuotient(body.V).minCoeff(), 0.44 - 1e-8);
  EXPECT_LE(V.cwiseQuotient(body.V).maxCoeff(), 1.4 + 1e-8);
  for (const auto& [i, j] : monomials<2>(2)) {
    double sum = 0.0;
    for (Index q = 0; q < body.size(); ++q)
      sum += V[q] * std::pow(body.X(q, 0), i) * std::pow(body.X(q, 1), j);
    const double exact = std::pow(a, i + 1) * std::pow(b, j + 1) * std::tgamma(i + 1) *
                         std::tgamma(j + 1) / std::tgamma(i + j + 3);
    EXPECT_NEAR(sum, exact, 1e-12) << i << j;
  }
}

/// Square corners and even cells need no bounds.
TEST(LocalVolumes, OfABoxLieWithinTheBoundsByThemselves) {
  for (const int cells : {6, 24}) {
    const Particles<2> body = square(cells, 0.0);

    const ScalarField share = local_volumes<2>(body).cwiseQuotient(body.V);

    EXPECT_GT(share.minCoeff(), 0.445);
    EXPECT_LT(share.maxCoeff(), 1.35);
  }
}

TEST(LocalVolumes, OfParticlesWithoutCellsStay) {
  const Shape<2> shape = make_box<2>({0.0, 0.0}, {1.0, 1.0});
  const Particles<2> body = make_lattice<2>(shape, 0.1, NodePlacement::cell_centred);

  EXPECT_EQ(local_volumes<2>(body), body.V);
}

}  // namespace
}  // namespace tlsph

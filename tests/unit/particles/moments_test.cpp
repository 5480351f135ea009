/// Quadrature by particles: exact moments of the body that its faces enclose.

#include "tlsph/particles/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

Particles<2> jittered_square(double jitter) {
  const Shape<2> shape = make_box<2>({1.0, 2.0}, {3.0, 4.0});
  return jittered<2>(make_lattice<2>(shape, 0.25, NodePlacement::on_boundary, {}), jitter, 3);
}

/// ∫ x^i over [a, b].
double line_integral(double a, double b, int i) {
  return (std::pow(b, i + 1) - std::pow(a, i + 1)) / (i + 1);
}

TEST(Monomials, ComeByDegree) {
  const std::vector<std::array<int, 2>> expected = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};

  EXPECT_EQ(monomials<2>(2), expected);
  EXPECT_EQ(monomials<1>(3).size(), 4U);
  EXPECT_EQ((monomial_values<2>(expected, Vector<2>(2.0, 3.0))),
            (Eigen::VectorXd(6) << 1.0, 2.0, 3.0, 4.0, 6.0, 9.0).finished());
}

TEST(ExactMoments, OfAnIntervalAreThoseOfItsEnds) {
  Particles<1> bar =
      make_lattice<1>(make_interval(0.5, 2.0), 0.125, NodePlacement::on_boundary, {});
  bar = with_exact_moments<1>(jittered<1>(std::move(bar), 0.3, 5), {2, 3});

  for (const int i : {0, 1, 2}) {
    double sum = 0.0;
    for (Index q = 0; q < bar.size(); ++q) sum += bar.V[q] * std::pow(bar.X(q, 0), i);
    EXPECT_NEAR(sum, line_integral(0.5, 2.0, i), 1e-13) << i;
  }
  EXPECT_NEAR(bar.B.sum(), 0.0, 1e-15);
  EXPECT_NEAR(bar.B.maxCoeff(), 1.0, 1e-14);
}

TEST(ExactMoments, OfASquareAreThoseOfItsShape) {
  const Particles<2> body = with_exact_moments<2>(jittered_square(0.2), {2, 3});

  for (const auto& exponents : monomials<2>(3)) {
    const auto [i, j] = exponents;
    double volume = 0.0;
    Vector<2> boundary = Vector<2>::Zero();
    for (Index q = 0; q < body.size(); ++q) {
      const double value = std::pow(body.X(q, 0), i) * std::pow(body.X(q, 1), j);
      volume += body.V[q] * value;
      boundary += value * body.B.row(q).transpose();
    }
    if (i + j <= 2) {
      EXPECT_NEAR(volume, line_integral(1, 3, i) * line_integral(2, 4, j), 1e-11) << i << j;
    }
    EXPECT_NEAR(boundary.x(), (std::pow(3, i) - std::pow(1, i)) * line_integral(2, 4, j), 2e-11)
        << i << j;
    EXPECT_NEAR(boundary.y(), (std::pow(4, j) - std::pow(2, j)) * line_integral(1, 3, i), 2e-11)
        << i << j;
  }
}

TEST(ExactMoments, ChangeAsLittleAsTheyMust) {
  const Particles<2> before = jittered_square(0.0);

  const Particles<2> same = with_exact_moments<2>(before, {1, 1});
  const Particles<2> after = with_exact_moments<2>(before, {2, 3});

  EXPECT_LE((same.V - before.V).cwiseAbs().maxCoeff(), 1e-16) << "the trapezoidal rule is linear";
  EXPECT_LE((same.B - before.B).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LE(((after.V - before.V).array() / before.V.array()).abs().maxCoeff(), 0.15)
      << "at corners, of eight cells a side";
  EXPECT_EQ(after.X, before.X);
}

TEST(ExactMoments, KeepTheSharesOfPatchesInStep) {
  const Particles<2> body = with_exact_moments<2>(jittered_square(0.2), {2, 3});

  VectorField<2> B = VectorField<2>::Zero(body.size(), 2);
  for (const char* side : {"left", "right", "bottom", "top"})
    for (const Face<2>& face : body.find(side)->faces)
      for (std::size_t k = 0; k < 2; ++k)
        B.row(face.nodes[k]) += face.share[k] * face.area.transpose();
  EXPECT_LE((B - body.B).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(ExactMoments, OfACurvedBodyAreThoseOfItsArcs) {
  const Shape<2> shape = make_difference(make_disc({0.0, 0.0}, 1.0), {make_disc({0.2, 0.1}, 0.3)});
  const Particles<2> lattice = make_lattice<2>(shape, 0.1, NodePlacement::on_boundary, {});

  const Particles<2> body = with_exact_moments<2>(fitted(lattice, shape), {2, 3}, &shape);

  constexpr double circle = std::numbers::pi;
  EXPECT_NEAR(body.V.sum(), circle * (1.0 - 0.09), 1e-12);
  EXPECT_NEAR(body.V.dot(body.X.col(0)), -circle * 0.09 * 0.2, 1e-13);
  const double second =
      circle / 4 - (circle / 4 * std::pow(0.3, 4) + circle * 0.09 * 0.04);  // of x²
  EXPECT_NEAR(body.V.dot(body.X.col(0).cwiseAbs2()), second, 1e-12);
  EXPECT_NEAR(body.B.col(0).dot(body.X.col(0)), body.V.sum(), 1e-12);
  EXPECT_NEAR(body.B.col(0).dot(body.X.col(0).array().cube().matrix()) / 3.0, second, 1e-12);
}

/// The shallower an arc, the nearer x² and y are to depending on one another along it.
TEST(ExactMoments, OfShallowArcsAreMet) {
  for (const double radius : {2.0, 6.0, 30.0, 200.0, 3e3, 5e4, 1e6}) {
    const double sagitta = radius - std::sqrt(radius * radius - 0.25);
    const Shape<2> shape = make_difference(make_box<2>({0.0, 0.0}, {1.0, 1.0}),
                                           {make_disc({0.5, 0.1 - radius}, radius)});
    const Particles<2> lattice = make_lattice<2>(shape, 0.1, NodePlacement::on_boundary, {});
    for (const double jitter : {0.0, 0.2}) {
      SCOPED_TRACE(testing::Message() << "radius " << radius << ", jitter " << jitter);
      const Particles<2> before = jittered<2>(fitted(lattice, shape), jitter, 3);

      const Particles<2> body = with_exact_moments<2>(before, {2, 3}, &shape);

      // Of the cap above y = 0.1 − sagitta, half an angle φ: R²(φ − sin φ cos φ).
      const double phi = std::asin(0.5 / radius);
      const double cap = sagitta < 1e-4 ? 2.0 / 3.0 * sagitta
                                        : radius * radius * (phi - std::sin(phi) * std::cos(phi));
      const double rounding = 1e-12 + 4e-16 * radius;  // of nodes on the arc
      EXPECT_NEAR(body.V.sum(), 0.9 + sagitta - cap, 1e-9);
      EXPECT_NEAR(body.B.col(1).dot(body.X.col(1)), body.V.sum(), rounding);
      EXPECT_NEAR(body.B.col(0).dot(body.X.col(0)), body.V.sum(), rounding);
      EXPECT_NEAR(body.B.col(0).dot(body.X.col(0).array().cube().matrix()) / 3.0,
                  body.V.dot(body.X.col(0).cwiseAbs2()), rounding);
      EXPECT_NEAR(body.B.colwise().sum().norm(), 0.0, rounding);
      for (const Face<2>& face : body.find("boundary")->faces)
        for (const double share : face.share) EXPECT_NEAR(share, 0.5, 0.2);
    }
  }
}

TEST(ExactMoments, RefuseWhatHasNoParticlesOnItsBoundary) {
  const Shape<2> shape = make_box<2>({0.0, 0.0}, {1.0, 1.0});
  const Particles<2> body = make_lattice<2>(shape, 0.1, NodePlacement::cell_centred, {});

  EXPECT_THROW(static_cast<void>(with_exact_moments<2>(body, {2, 3})), InputError);
}

}  // namespace
}  // namespace tlsph

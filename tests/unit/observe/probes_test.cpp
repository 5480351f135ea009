/// Probes of a homogeneous deformation show it wherever they are.

#include "tlsph/observe/probes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "tlsph/core/error.hpp"
#include "unit/dynamics/bodies.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;

const std::vector<std::string> everything = {
    "displacement", "velocity", "acceleration", "deformation_gradient",
    "pk1",          "cauchy",   "pressure",     "von_mises"};

Tensor<2> stretch() {
  Tensor<2> H;
  H << 0.2, 0.1, -0.05, -0.1;
  return H;
}

/// A sheet that is stretched evenly and flies.
struct Sheet {
  Discretisation<2> body = test::cells_of<2>(4, LawName::neo_hookean);
  State<2> state = make_state<2>(body, VectorField<2>(body.particles.X* stretch().transpose()),
                                 Vector<2>(3.0, -2.0).transpose().replicate(body.nodes(), 1));
  Sheet() {
    state.last_dt = 1e-5;
    evaluate<2>(body, state);
  }
};

class ProbePlaces : public testing::TestWithParam<Vector<2>> {};

TEST_P(ProbePlaces, ShowTheHomogeneousState) {
  const Sheet sheet;
  const Vector<2> at = GetParam();
  const Probes<2> probes(
      sheet.body,
      {{"p",
        at,
        {"displacement", "deformation_gradient", "pk1", "cauchy", "pressure", "von_mises"}}});
  std::vector<double> row(probes.columns().size());

  probes.sample({sheet.body, sheet.state, 1e-5}, row);

  const Tensor<2> H = stretch();
  const Tensor<2> F = Tensor<2>::Identity() + H;
  const auto& law = sheet.body.regions[0].law;
  const Tensor<2> P = pk1<2>(law, H);
  const Tensor<2> sigma = P * F.transpose() / F.determinant();
  const double third = std::visit([&](const auto& some) { return some.transverse_stress(H); }, law);
  const double mean = (sigma.trace() + third) / 3.0;
  const Tensor<2> s = sigma - mean * Tensor<2>::Identity();
  const double mises = std::sqrt(1.5 * (s.squaredNorm() + std::pow(third - mean, 2)));
  const Vector<2> u = H * at;
  const std::vector<double> expected = {u[0],        u[1],        F(0, 0),     F(0, 1), F(1, 0),
                                        F(1, 1),     P(0, 0),     P(0, 1),     P(1, 0), P(1, 1),
                                        sigma(0, 0), sigma(0, 1), sigma(1, 1), -mean,   mises};
  ASSERT_EQ(row.size(), expected.size());
  for (std::size_t k = 0; k < row.size(); ++k)
    EXPECT_NEAR(row[k], expected[k], 1e-12 * std::max(1.0, std::abs(expected[k])))
        << probes.columns()[k];
}

/// At a node, at a stress point, between both, on an edge and in a corner.
INSTANTIATE_TEST_SUITE_P(, ProbePlaces,
                         testing::Values(Vector<2>(0.04, 0.02), Vector<2>(0.03, 0.03),
                                         Vector<2>(0.0371, 0.0612), Vector<2>(0.08, 0.033),
                                         Vector<2>(0.0, 0.08)));

TEST(Probes, NameTheirColumns) {
  const auto sheet = test::cells_of<2>(2);
  const auto bar = test::cells_of<1>(2);

  EXPECT_THAT(
      Probes<2>(sheet, {{"a", Vector<2>(0.0, 0.0), everything}}).columns(),
      ElementsAre("a.displacement_x", "a.displacement_y", "a.velocity_x", "a.velocity_y",
                  "a.acceleration_x", "a.acceleration_y", "a.deformation_gradient_xx",
                  "a.deformation_gradient_xy", "a.deformation_gradient_yx",
                  "a.deformation_gradient_yy", "a.pk1_xx", "a.pk1_xy", "a.pk1_yx", "a.pk1_yy",
                  "a.cauchy_xx", "a.cauchy_xy", "a.cauchy_yy", "a.pressure", "a.von_mises"));
  EXPECT_THAT(
      Probes<1>(bar, {{"b", Vector<1>(0.0), {"displacement", "pk1"}}, {"c", Vector<1>(0.02), {}}})
          .columns(),
      ElementsAre("b.displacement_x", "b.pk1_xx"));
}

/// v_n = v_{n−½} + ½ Δt_{n−1} a_n, a_n from the difference of the half-step velocities: exact under
/// constant acceleration where steps are unequal too.
TEST(Probes, ShowVelocityAtTheTimeOfTheDisplacement) {
  auto body = test::cells_of<1>(2);
  body.body_force[0] = 4.0;
  State<1> state =
      make_state<1>(body, VectorField<1>::Zero(3, 1), VectorField<1>::Constant(3, 1, 5.0));
  evaluate<1>(body, state);
  start<1>(body, state, 1e-3);
  const Probes<1> probes(body, {{"p", Vector<1>(0.013), {"velocity", "acceleration"}}});
  std::vector<double> row(2);

  probes.sample({body, state, 1e-3}, row);
  EXPECT_NEAR(row[0], 5.0, 1e-14);
  EXPECT_NEAR(row[1], 4.0, 1e-11);

  advance<1>(body, state, 1e-3, 1e-3);
  evaluate<1>(body, state);
  probes.sample({body, state, 5e-4}, row);
  EXPECT_NEAR(row[0], 5.0 + 4.0 * 1e-3, 1e-14);
  EXPECT_NEAR(row[1], 4.0, 1e-11);
}

/// From cells of F = 1 and F = 0.1 the end is extrapolated to F < 0.
TEST(Probes, ShowTheStressOfTheNearestPointBeyondTheRangeOfTheLaw) {
  const auto body = test::cells_of<1>(4, LawName::neo_hookean);
  VectorField<1> u = VectorField<1>::Zero(5, 1);
  u(4, 0) = -0.9 * body.spacing;
  State<1> state = make_state<1>(body, u, VectorField<1>::Zero(5, 1));
  evaluate<1>(body, state);
  const Vector<1> end = body.particles.X.row(4).transpose();
  const Probes<1> probes(body, {{"p", end, {"deformation_gradient", "cauchy", "von_mises"}}});
  std::vector<double> row(3);

  probes.sample({body, state, 1e-5}, row);

  EXPECT_LT(row[0], 0.0);
  EXPECT_NEAR(row[1] / state.P(3, 0), 1.0, 1e-12);
  EXPECT_TRUE(std::isfinite(row[2]) && row[2] > 0.0) << row[2];
}

TEST(Probes, RefuseAQuantityThereIsNot) {
  EXPECT_THROW(Probes<1>(test::cells_of<1>(2), {{"p", Vector<1>(0.0), {"temperature"}}}),
               InputError);
}

}  // namespace
}  // namespace tlsph

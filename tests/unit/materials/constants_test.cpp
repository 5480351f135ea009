#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

#include "tlsph/core/error.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/stress.hpp"
#include "tlsph/materials/uniaxial.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

TEST(Constants, LameByHand) {
  const auto [lambda, mu] = lame(200e9, 0.25);
  EXPECT_DOUBLE_EQ(lambda, 80e9);
  EXPECT_DOUBLE_EQ(mu, 80e9);
}

TEST(Constants, ImpossibleOnesAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double young : {0.0, -1.0, nan, infinity})
    EXPECT_THROW((void)make_law<2>(LawName::neo_hookean, Assumption::strain, young, 0.3),
                 InputError);
  for (const double poisson : {-1.0, 0.5, 0.7, nan})
    EXPECT_THROW((void)make_law<1>(LawName::linear_elastic, Assumption::stress, 1.0, poisson),
                 InputError);
}

/// The bar of the thesis: 5801 m/s in 1D strain, 5000 in 1D stress, 5241 in plane stress.
TEST(Waves, SpeedsOfTheSteelBar) {
  const auto speed = [](int dimension, Assumption assumption) {
    return wave_speed(p_modulus(dimension, assumption, 200e9, 0.3), 8000);
  };
  EXPECT_NEAR(speed(1, Assumption::strain), 5801.19, 0.01);
  EXPECT_NEAR(speed(2, Assumption::strain), 5801.19, 0.01);
  EXPECT_NEAR(speed(3, Assumption::stress), 5801.19, 0.01);
  EXPECT_NEAR(speed(1, Assumption::stress), 5000.0, 1e-9);
  EXPECT_NEAR(speed(2, Assumption::stress), std::sqrt(200e9 / (8000 * 0.91)), 1e-9);
  EXPECT_NEAR(wave_speed(lame(200e9, 0.3).mu, 8000), 3100.87, 0.01);
}

TEST(Waves, TheSlowestWaveOfTheUndeformedBodyIsTheShearWave) {
  const auto law = make_law<2>(LawName::neo_hookean, Assumption::strain, 2.5, 0.3);
  const Tangent<2> A = tangent<2>(law, Tensor<2>::Zero());
  EXPECT_NEAR(smallest_acoustic_eigenvalue<2>(A), 2.5 / 2.6, 1e-14);
  EXPECT_TRUE(is_hyperbolic<2>(A));
}

/// Only a shear modulus μ and a deficit along the direction N₀: the smallest eigenvalue is
/// μ − k (N·N₀)⁴ with polarisation N₀, least at N = N₀, which lies between the scanned angles.
TEST(Waves, TheWorstDirectionIsFoundBetweenScannedAngles) {
  const double mu = 1.0, deficit = 1.5, angle = 0.7123;
  const Vector<2> N(std::cos(angle), std::sin(angle));
  const Tensor<2> dyad = N * N.transpose();
  const Eigen::Map<const Eigen::Vector4d> m(dyad.data());
  const Tangent<2> A = mu * Tangent<2>::Identity() - deficit * m * m.transpose();
  EXPECT_NEAR(smallest_acoustic_eigenvalue<2>(A), mu - deficit, 1e-14);
  EXPECT_FALSE(is_hyperbolic<2>(A));
}

TEST(Kinematics, LogOnePlusXMinusXJoinsItsBranches) {
  for (const double x : {-0.9, -0.2500001, -0.2499999, 0.2499999, 0.2500001, 3.0})
    EXPECT_NEAR(log1p_minus(x), std::log1p(x) - x, 2e-16 + 1e-15 * std::abs(x)) << x;
  // −x²/2 + x³/3 − x⁴/4
  EXPECT_DOUBLE_EQ(log1p_minus(1e-5), -5e-11 + 1e-15 / 3 - 2.5e-21);
  EXPECT_DOUBLE_EQ(log_volume(1e-9), 1e-9 - 5e-19);
  EXPECT_TRUE(std::isnan(log_volume(-1.0)));
  EXPECT_TRUE(std::isnan(log_volume(-2.0)));
}

TEST(Kinematics, VolumeChangeIsTheDeterminantLessOne) {
  Tensor<3> H;
  H << 0.1, -0.2, 0.3, 0.05, 0.4, -0.1, 0.2, 0.15, -0.3;
  const Tensor<3> F = Tensor<3>::Identity() + H;
  const double J = F.row(0).dot(F.row(1).cross(F.row(2)));
  EXPECT_NEAR(1 + volume_change<3>(H), J, 1e-15);
  EXPECT_LE((F * cofactor<3>(F).transpose() - J * Tensor<3>::Identity()).norm(), 1e-15);
  EXPECT_LE((deformation_minus_cofactor<3>(H) - (F - cofactor<3>(F))).norm(), 1e-15);
}

TEST(Stress, CauchyOfASmallStrainLawIsP) {
  const auto law = make_law<2>(LawName::linear_elastic, Assumption::strain, 2.5, 0.3);
  const Tensor<2> H = 0.1 * Tensor<2>::Identity();
  const Tensor<2> P = pk1<2>(law, H);
  EXPECT_EQ(cauchy<2>(law, H, P), P);
}

TEST(Stress, CauchyOfAStretchedBar) {
  // F = 2 in 1D stress: σ = P F/(F s²)
  const auto law = make_law<1>(LawName::neo_hookean, Assumption::stress, 2.5, 0.3);
  const Tensor<1> H(1.0);
  const Tensor<1> P = pk1<1>(law, H);
  const double s = std::get<NeoHookean<1, Assumption::stress>>(law).transverse_stretch(H);
  EXPECT_NEAR(cauchy<1>(law, H, P)(0, 0), P(0, 0) / (s * s), 1e-15);
  EXPECT_EQ(transverse_stress<1>(law, H), 0.0);
}

TEST(Stress, MeasuresByHand) {
  Tensor<2> sigma;
  sigma << 4.0, 3.0, 3.0, 1.0;
  EXPECT_DOUBLE_EQ(pressure<2>(sigma, 1.0), -2.0);
  // s = diag(2, −1, −1) and shear 3: √(1.5 (6 + 18)) = 6
  EXPECT_DOUBLE_EQ(von_mises<2>(sigma, 1.0), 6.0);
  EXPECT_DOUBLE_EQ(von_mises<1>(Tensor<1>(-5.0), -2.0), 3.0);
  EXPECT_DOUBLE_EQ(pressure<1>(Tensor<1>(-5.0), -2.0), 3.0);
}

class Uniaxial : public testing::TestWithParam<std::tuple<LawName, Assumption, double>> {};

template <int D>
void expect_inverse(const AnyLaw<D>& law, double x) {
  Tensor<D> H = Tensor<D>::Zero();
  H(0, 0) = x;
  const double found = uniaxial_gradient<D>(law, pk1<D>(law, H)(0, 0));
  EXPECT_NEAR(found, x, 4e-15 * std::abs(x)) << D << "D";
}

TEST_P(Uniaxial, GivesBackTheStretch) {
  const auto [name, assumption, x] = GetParam();
  expect_inverse<1>(make_law<1>(name, assumption, 2.5e9, 0.3), x);
  expect_inverse<2>(make_law<2>(name, assumption, 2.5e9, 0.3), x);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, Uniaxial,
    testing::Combine(testing::Values(LawName::linear_elastic, LawName::st_venant_kirchhoff,
                                     LawName::neo_hookean),
                     testing::Values(Assumption::strain, Assumption::stress),
                     testing::Values(-0.3, -1e-5, -1e-9, 0.0, 1e-9, 3e-4, 0.5, 2.0)));

TEST(UniaxialLimits, ATractionNoStateCarriesIsRefused) {
  // St Venant–Kirchhoff: P = M F (F² − 1)/2 is least, −M/(3√3), at F = 1/√3.
  const double limit = p_modulus(1, Assumption::strain, 2.5, 0.3) / (3 * std::sqrt(3.0));
  const auto law = make_law<1>(LawName::st_venant_kirchhoff, Assumption::strain, 2.5, 0.3);
  EXPECT_NEAR(uniaxial_gradient<1>(law, -0.999999 * limit), 1 / std::sqrt(3.0) - 1, 1e-3);
  EXPECT_THROW((void)uniaxial_gradient<1>(law, -1.000001 * limit), InputError);
}

TEST(UniaxialLimits, TheBranchEndsWhereHyperbolicityIsLost) {
  const auto law = make_law<1>(LawName::neo_hookean, Assumption::strain, 2.5, 0.49);
  const double top = pk1<1>(law, Tensor<1>(2.63))(0, 0);
  EXPECT_LT(uniaxial_gradient<1>(law, 0.999 * top), 2.63);
  EXPECT_THROW((void)uniaxial_gradient<1>(law, 1.001 * top), InputError);
}

}  // namespace
}  // namespace tlsph

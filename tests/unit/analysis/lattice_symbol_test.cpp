#include "tlsph/analysis/lattice_symbol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tlsph {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 0.5;
constexpr double speed = 3.0;

/// Springs between neighbours `apart` nodes away: ω = (2c/(apart Δ)) |sin(apart θ/2)|.
LatticeSymbol<1> chain(int apart) {
  const double k = std::pow(speed / (apart * spacing), 2);
  const auto at = [&](double d) { return Vector<1>(d * apart * spacing); };
  return {{at(-1), at(0), at(1)}, {Tensor<1>(-k), Tensor<1>(2 * k), Tensor<1>(-k)}};
}

/// Two uncoupled components on a square lattice, each its own wave speed in both directions.
LatticeSymbol<2> membrane(double transverse, double longitudinal) {
  Tensor<2> k = Tensor<2>::Zero();
  k(0, 0) = std::pow(longitudinal / spacing, 2);
  k(1, 1) = std::pow(transverse / spacing, 2);
  LatticeSymbol<2> symbol{{Vector<2>::Zero()}, {4.0 * k}};
  for (const auto& [i, j] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    symbol.offset.emplace_back(Vector<2>(i, j) * spacing);
    symbol.block.emplace_back(-k);
  }
  return symbol;
}

class Chain : public testing::TestWithParam<int> {};

TEST_P(Chain, TravelsAsSpringsDo) {
  const int apart = GetParam();
  constexpr int radial = 16;

  const auto speeds = phase_speeds<1>(chain(apart), spacing, {speed}, radial, 1);

  ASSERT_EQ(speeds.k.size(), radial);
  for (std::size_t n = 0; n < speeds.k.size(); ++n) {
    const double theta = pi * static_cast<double>(n + 1) / radial;
    EXPECT_NEAR(speeds.k[n][0], theta, 1e-14);
    EXPECT_NEAR(speeds.relative[n][0], std::abs(std::sin(apart * theta / 2)) / (apart * theta / 2),
                1e-14);
  }
}
INSTANTIATE_TEST_SUITE_P(Neighbours, Chain, testing::Values(1, 2, 3));

TEST(ZeroEnergyWaves, AreThoseThatNoSpringSees) {
  const Vector<1> spacings(spacing);

  EXPECT_EQ(zero_energy_waves<1>(chain(1), spacings, speed), 0);
  EXPECT_EQ(zero_energy_waves<1>(chain(2), spacings, speed), 1);
}

TEST(SquaredFrequencies, TellTransverseFromLongitudinalByTheirMotion) {
  const Vector<2> along_x(0.3 / spacing, 0.0);
  const double sine = 4.0 * std::pow(std::sin(0.15) / spacing, 2);

  // The slower wave is the longitudinal one in the second: the order is not that of size.
  for (const auto& [transverse, longitudinal] : {std::pair{1.0, 2.0}, {2.0, 1.0}}) {
    const auto squares = squared_frequencies<2>(membrane(transverse, longitudinal), along_x);

    EXPECT_NEAR(squares[0], transverse * transverse * sine, 1e-13);
    EXPECT_NEAR(squares[1], longitudinal * longitudinal * sine, 1e-13);
  }
}

TEST(SquaredFrequencies, AreNegativeWhereAWaveGrows) {
  LatticeSymbol<1> unstable = chain(1);
  for (Tensor<1>& block : unstable.block) block = -block;

  EXPECT_LT(squared_frequencies<1>(unstable, Vector<1>(1.0))[0], 0.0);
  EXPECT_EQ(phase_speeds<1>(unstable, spacing, {speed}, 4, 1).relative[0][0], 0.0);
}

TEST(PhaseSpeeds, CoverTheQuarterOfTheZone) {
  const auto speeds = phase_speeds<2>(membrane(1.0, 2.0), spacing, {1.0, 2.0}, 8, 4);

  ASSERT_EQ(speeds.k.size(), 8U * 5U);
  EXPECT_NEAR(speeds.k.front().norm(), pi / 8, 1e-14);
  EXPECT_NEAR(speeds.k.back()[0], 0.0, 1e-14);
  EXPECT_NEAR(speeds.k.back()[1], pi, 1e-14);
}

}  // namespace
}  // namespace tlsph

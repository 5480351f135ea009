/// The symbol of the current sums: closed forms, and the growth that the sums themselves show.

#include "tlsph/contrast/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/contrast/updated_lagrangian.hpp"

namespace tlsph {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
StressedLattice<D> unit_lattice(double stress, double mu = 0.0) {
  return {CubicSpline{}, 2.4, 1.0, {1.0 - 2.0 * mu, mu}, 1.0, stress};
}

/// At k = π/Δ only the nearest neighbours count: C = 4 W''(Δ) Δ, and the stiffness vanishes.
TEST(GrowthRate, OfTheShortestWaveIsThatOfTheNearestNeighbours) {
  const double C = 4.0 * kernel_second<1>(CubicSpline{}, 1.0, 2.4);

  const double rate = growth_rate<1>(unit_lattice<1>(0.05), Vector<1>(pi));

  EXPECT_NEAR(rate, std::sqrt(2.0 * 0.05 * C), 1e-14);
  EXPECT_NEAR(rate, 0.340, 5e-4);
}

TEST(GrowthRate, IsZeroInCompressionAndWithoutStress) {
  EXPECT_EQ(fastest_growth<1>(unit_lattice<1>(-0.05)).rate, 0.0);
  EXPECT_EQ(fastest_growth<2>(unit_lattice<2>(-0.05, 0.25)).rate, 0.0);
  EXPECT_NEAR(fastest_growth<2>(unit_lattice<2>(0.0)).rate, 0.0, 1e-7);  // √ of round-off
}

TEST(GrowthRate, FindsTheShortestWaveTheWorst) {
  const GrowingWave<1> wave = fastest_growth<1>(unit_lattice<1>(0.05));

  EXPECT_NEAR(wave.k[0], pi, 1e-12);
  EXPECT_EQ(wave.rate, growth_rate<1>(unit_lattice<1>(0.05), wave.k));
}

/// Long waves travel at √((λ+2μ)/ρ) and √(μ/ρ); the bare sum of this kernel is 1 % off in strain.
TEST(Symbol, OfLongWavesIsThatOfElasticity) {
  constexpr double mu = 0.25, k = 1e-3;

  const Tensor<2> s = symbol<2>(unit_lattice<2>(0.0, mu), Vector<2>(k, 0.0));

  EXPECT_NEAR(-s(0, 0) / (k * k), 1.0, 0.03);
  EXPECT_NEAR(s(1, 1) / s(0, 0), mu, 1e-6);
  EXPECT_NEAR(s(0, 1), 0.0, 1e-18);
}

/// −symbol · u is what a small plane displacement does to the accelerations.
TEST(Symbol, IsTheDerivativeOfTheSums) {
  const StressedLattice<2> lattice = unit_lattice<2>(0.05, 0.2);
  const Vector<2> k(0.7 * pi, 0.3 * pi);
  const Vector<2> direction(0.6, -0.8);
  constexpr double size = 1e-6;
  constexpr int n = 21;
  constexpr int half = n / 2;
  CurrentBody<2> body{lattice.kernel, lattice.h, lattice.moduli, ScalarField::Ones(n * n),
                      VectorField<2>::Zero(n * n, 2)};
  CurrentState<2> state{0.0, VectorField<2>(n * n, 2), VectorField<2>(n * n, 2),
                        ScalarField::Ones(n * n), TensorField<2>::Zero(n * n, 4)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Index q = i * n + j;
      state.x.row(q) << i - half, j - half;
      state.v.row(q) = size * std::cos(k.dot(state.x.row(q).transpose())) * direction.transpose();
      state.stress.row(q) << lattice.stress, 0.0, 0.0, lattice.stress;
    }

  advance<2>(body, state, 1.0);  // held, so the step is the displacement v and nothing else

  const Index middle = n * n / 2;
  const VectorField<2> a = acceleration<2>(body, state);
  const Vector<2> expected = size * symbol<2>(lattice, k) * direction;
  EXPECT_NEAR((a.row(middle).transpose() - expected).norm(), 0.0, 1e-4 * expected.norm());
}

/// A ring cannot be had without periodic neighbours; a long bar whose ends the growth does not
/// reach shows the rate of its shortest wave.
TEST(GrowthRate, IsWhatTheSumsShow) {
  constexpr int n = 121;
  CurrentBody<1> body{
      CubicSpline{}, 2.4, {1.0, 0.0}, ScalarField::Ones(n), VectorField<1>::Ones(n, 1)};
  body.motion.topRows(5).setZero();
  body.motion.bottomRows(5).setZero();
  CurrentState<1> state{0.0, VectorField<1>::LinSpaced(n, 0.0, n - 1.0), VectorField<1>::Zero(n, 1),
                        ScalarField::Ones(n), TensorField<1>::Constant(n, 1, 0.05)};
  for (int i = 5; i < n - 5; ++i) state.v(i) = i % 2 == 0 ? 1e-9 : -1e-9;
  constexpr double dt = 0.05;
  const auto energy_after = [&](int steps) {
    for (int step = 0; step < steps; ++step) advance<1>(body, state, dt);
    return kinetic_energy<1>(body, state);
  };

  const double first = energy_after(400);
  const double second = energy_after(400);

  const double rate = 0.5 * std::log(second / first) / (400 * dt);
  EXPECT_NEAR(rate, fastest_growth<1>(unit_lattice<1>(0.05)).rate, 2e-3);
}

}  // namespace
}  // namespace tlsph

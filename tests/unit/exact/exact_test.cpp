#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"
#include "tlsph/exact/solutions.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

/// Fourth-order central difference.
template <class F>
std::invoke_result_t<F, double> difference(F f, double x, double step) {
  using Value = std::invoke_result_t<F, double>;
  const Value near_change = f(x + step) - f(x - step);
  const Value far_change = f(x + 2 * step) - f(x - 2 * step);
  return (8 * near_change - far_change) / (12 * step);
}

/// v = ∂u/∂t and ρ ∂v/∂t = Div P at X and t, relative to the given scales.
template <int D>
void expect_motion(const ExactSolution<D>& exact, double density, const Vector<D>& X, double t,
                   double dx, double dt, double velocity_scale, double force_scale) {
  const Vector<D> u_rate = difference([&](double s) { return exact.displacement(X, s); }, t, dt);
  const Vector<D> v_rate = difference([&](double s) { return exact.velocity(X, s); }, t, dt);
  Vector<D> force = Vector<D>::Zero();
  for (int a = 0; a < D; ++a)
    force += difference(
        [&](double x) -> Vector<D> {
          Vector<D> moved = X;
          moved[a] = x;
          return exact.stress(moved, t).col(a);
        },
        X[a], dx);
  EXPECT_LE((exact.velocity(X, t) - u_rate).norm(), 1e-6 * velocity_scale) << "t = " << t;
  EXPECT_LE((density * v_rate - force).norm(), 1e-5 * force_scale) << "t = " << t;
}

/// P = M ∂u/∂x by finite differences.
template <int D>
double strain_xx(const ExactSolution<D>& exact, const Vector<D>& X, double t, double dx) {
  return difference(
      [&](double x) {
        Vector<D> moved = X;
        moved[0] = x;
        return exact.displacement(moved, t)[0];
      },
      X[0], dx);
}

using Side = BarWave::Side;
using Support = BarWave::Support;

/// The bar of the thesis, shifted so that its lower end is not the origin.
BarWave steel_bar(Side loaded, Support far_end) {
  BarWave bar;
  bar.lower = -0.05;
  bar.length = 0.15;
  bar.modulus = p_modulus(1, Assumption::strain, 200e9, 0.3);
  bar.lateral_modulus = lame(200e9, 0.3).lambda;
  bar.density = 8000;
  bar.traction = PulseCurve{-100e3, 8e-6, 1e-6};
  bar.loaded = loaded;
  bar.far_end = far_end;
  return bar;
}

class BarWaveTest : public testing::TestWithParam<std::tuple<Side, Support>> {
 protected:
  const BarWave bar = steel_bar(std::get<0>(GetParam()), std::get<1>(GetParam()));
  const double c = std::sqrt(bar.modulus / bar.density);
  const double upper = bar.lower + bar.length;
  const double loaded_end = bar.loaded == Side::lower ? bar.lower : upper;
  const double far_end = bar.loaded == Side::lower ? upper : bar.lower;
};

TEST_P(BarWaveTest, SolvesTheWaveEquation) {
  const auto exact = bar_wave<2>(bar);
  const double velocity = 100e3 / (bar.density * c), force = 100e3 / (c * 1e-6);
  for (const double share : {0.07, 0.31, 0.5, 0.83})
    for (int i = 1; i < 60; ++i) {
      const Vector<2> X(bar.lower + share * bar.length, 0.01);
      const double t = i * 2.5e-6;  // up to three round trips
      expect_motion<2>(exact, bar.density, X, t, 5e-5, 1e-8, velocity, force);
      const double strain = strain_xx<2>(exact, X, t, 5e-5);
      const Tensor<2> P = exact.stress(X, t);
      EXPECT_NEAR(P(0, 0), bar.modulus * strain, 1e-6 * 100e3);
      EXPECT_NEAR(P(1, 1), bar.lateral_modulus * strain, 1e-6 * 100e3);
      EXPECT_EQ(P(0, 1), 0.0);
      EXPECT_EQ(exact.displacement(X, t)[1], 0.0);
    }
}

TEST_P(BarWaveTest, KeepsItsBoundaryConditions) {
  const auto exact = bar_wave<1>(bar);
  const double scale = 100e3 / (bar.density * c) * 8e-6;  // the largest displacement, about
  for (int i = 0; i < 400; ++i) {
    const double t = i * 0.5e-6;
    EXPECT_NEAR(exact.stress(Vector<1>(loaded_end), t)(0, 0), value(bar.traction, t), 1e-8);
    if (bar.far_end == Support::fixed) {
      EXPECT_NEAR(exact.displacement(Vector<1>(far_end), t)[0], 0.0, 1e-13 * scale);
      EXPECT_NEAR(exact.velocity(Vector<1>(far_end), t)[0], 0.0, 1e-13 * scale / 8e-6);
    } else {
      EXPECT_NEAR(exact.stress(Vector<1>(far_end), t)(0, 0), 0.0, 1e-8);
    }
  }
}

TEST_P(BarWaveTest, StartsAtRestAndStaysSoUntilTheWaveArrives) {
  const auto exact = bar_wave<1>(bar);
  const Vector<1> X(loaded_end + 0.5 * (far_end - loaded_end));
  const double arrival = 0.5 * bar.length / c;
  EXPECT_EQ(exact.displacement(X, 0.0)[0], 0.0);
  EXPECT_EQ(exact.velocity(X, 0.999 * arrival)[0], 0.0);
  EXPECT_EQ(exact.stress(X, 0.999 * arrival)(0, 0), 0.0);
  EXPECT_NEAR(exact.stress(X, arrival + 3e-6)(0, 0), -50e3, 1);  // half way up its flank
  EXPECT_NEAR(exact.stress(X, arrival + 7e-6)(0, 0), -100e3, 1);
}

TEST_P(BarWaveTest, TheFarEndDoublesStressOrVelocity) {
  const auto exact = bar_wave<1>(bar);
  const double plateau = bar.length / c + 7e-6;
  const double towards_far = bar.loaded == Side::lower ? 1.0 : -1.0;
  const Vector<1> X(far_end);
  if (bar.far_end == Support::fixed)
    EXPECT_NEAR(exact.stress(X, plateau)(0, 0), -200e3, 1);
  else
    EXPECT_NEAR(exact.velocity(X, plateau)[0], towards_far * 2 * 100e3 / (bar.density * c), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Ends, BarWaveTest,
                         testing::Combine(testing::Values(Side::lower, Side::upper),
                                          testing::Values(Support::fixed, Support::free)));

/// Under a constant pull the fixed bar's stress goes p, 2p, p, 0 and again; the free bar's velocity
/// grows by 2p/Z at every visit: the momentum p t.
TEST(BarWaveReflections, ConstantPull) {
  BarWave bar;
  bar.length = 1;
  bar.modulus = 1;
  bar.density = 1;  // c = Z = 1
  bar.traction = ConstantCurve{1};
  const auto held = bar_wave<1>(bar);
  const Vector<1> X(0.75);
  const double expected[] = {0, 1, 2, 1, 0, 1, 2, 1};
  const double times[] = {0.5, 1.0, 1.5, 3.0, 4.0, 5.0, 5.5, 7.0};
  for (int i = 0; i < 8; ++i)
    EXPECT_DOUBLE_EQ(held.stress(X, times[i])(0, 0), expected[i]) << "t = " << times[i];

  bar.far_end = Support::free;
  const auto loose = bar_wave<1>(bar);
  EXPECT_DOUBLE_EQ(loose.velocity(X, 0.8)[0], -1.0);
  EXPECT_DOUBLE_EQ(loose.velocity(X, 1.5)[0], -2.0);
  EXPECT_DOUBLE_EQ(loose.velocity(X, 20.5)[0], -20.0);
  // after n transits the whole bar has moved by n²/2 × p L/(ρ c²), as a mass point would
  EXPECT_NEAR(loose.displacement(X, 20.0)[0], -200.0, 0.51);
}

TEST(BarWaveInput, ImpossibleBarsAreRefused) {
  BarWave bar = steel_bar(Side::lower, Support::fixed);
  bar.length = 0;
  EXPECT_THROW((void)bar_wave<1>(bar), InputError);
}

SwingingPlate rubber_plate() {
  SwingingPlate plate;
  plate.corner = Vector<2>(0.5, -1.0);
  plate.length = 2.0;
  plate.shear_modulus = lame(17e6, 0.3).mu;
  plate.density = 1100;
  plate.amplitude = 5e-4;
  return plate;
}

TEST(SwingingPlateTest, SolvesTheEquationOfMotion) {
  const SwingingPlate plate = rubber_plate();
  const auto exact = swinging_plate(plate);
  const double w = swinging_plate_frequency(plate);
  const double velocity = w * plate.amplitude, force = plate.density * w * velocity;
  for (const double x : {0.3, 1.1, 1.9})
    for (const double y : {0.2, 0.8, 1.6})
      for (const double t : {0.0, 1e-3, 7e-3})
        expect_motion<2>(exact, plate.density, plate.corner + Vector<2>(x, y), t, 1e-2, 0.01 / w,
                         velocity, force);
}

TEST(SwingingPlateTest, StressIsHookesOfTheDisplacement) {
  const SwingingPlate plate = rubber_plate();
  const auto exact = swinging_plate(plate);
  const LinearElastic<2> law(lame(17e6, 0.3));
  const Vector<2> X = plate.corner + Vector<2>(0.7, 1.3);
  Tensor<2> H;
  for (int a = 0; a < 2; ++a)
    H.col(a) = difference(
        [&](double x) {
          Vector<2> moved = X;
          moved[a] = x;
          return exact.displacement(moved, 1e-3);
        },
        X[a], 1e-2);
  EXPECT_LE((law.pk1(H) - exact.stress(X, 1e-3)).norm(), 1e-7 * law.pk1(H).norm());
}

TEST(SwingingPlateTest, EdgesSlide) {
  const SwingingPlate plate = rubber_plate();
  const auto exact = swinging_plate(plate);
  const Vector<2> upper = plate.corner + Vector<2>(plate.length, plate.length);
  for (const double s : {0.2, 1.0, 1.7}) {
    const double x = plate.corner[0] + s, y = plate.corner[1] + s;
    EXPECT_EQ(exact.displacement({plate.corner[0], y}, 0)[0], 0.0);
    EXPECT_EQ(exact.displacement({x, plate.corner[1]}, 0)[1], 0.0);
    EXPECT_NEAR(exact.displacement({upper[0], y}, 0)[1], 0.0, 1e-19);
    EXPECT_NEAR(exact.displacement({x, upper[1]}, 0)[0], 0.0, 1e-19);
  }
}

TEST(SwingingPlateTest, FrequencyOfTheUnitPlate) {
  SwingingPlate plate = rubber_plate();
  plate.length = 1;
  const double expected = std::numbers::pi / 2 * std::sqrt(2 * 17e6 / 2.6 / 1100);
  EXPECT_NEAR(swinging_plate_frequency(plate), expected, 1e-12 * expected);
}

/// The thesis's stretch from 15 to 90 mm.
TEST(UniformStretchTest, FollowsItsEnd) {
  const auto law = make_law<2>(LawName::neo_hookean, Assumption::strain, 200e9, 0.3);
  const auto exact = uniform_stretch<2>({0.0, 0.015, RampCurve{0.075, 1.0, true}}, law);
  const Vector<2> end(0.015, 0.004), middle(0.0075, 0.004);
  EXPECT_DOUBLE_EQ(exact.displacement(end, 2.0)[0], 0.075);
  EXPECT_DOUBLE_EQ(exact.displacement(middle, 0.5)[0], 0.075 / 4);
  EXPECT_EQ(exact.displacement(end, 2.0)[1], 0.0);
  EXPECT_EQ(exact.velocity(end, 2.0)[0], 0.0);
  EXPECT_DOUBLE_EQ(exact.velocity(middle, 0.5)[0], 0.5 * 0.075 * 30 / 16);

  const auto [lambda, mu] = lame(200e9, 0.3);
  const Tensor<2> P = exact.stress(middle, 2.0);  // F = diag(6, 1)
  EXPECT_NEAR(P(0, 0), mu * (6 - 1.0 / 6) + lambda * std::log(6.0) / 6, 1e-3);
  EXPECT_NEAR(P(1, 1), lambda * std::log(6.0), 1e-3);
}

TEST(UniformStretchTest, MayBeHeldAtEitherEnd) {
  const auto law = make_law<1>(LawName::linear_elastic, Assumption::stress, 7.0, 0.3);
  const auto exact = uniform_stretch<1>({2.0, -0.5, ConstantCurve{-0.1}}, law);
  EXPECT_EQ(exact.displacement(Vector<1>(2.0), 0.0)[0], 0.0);
  EXPECT_DOUBLE_EQ(exact.displacement(Vector<1>(1.5), 0.0)[0], -0.1);
  EXPECT_DOUBLE_EQ(exact.stress(Vector<1>(1.7), 0.0)(0, 0), 7.0 * 0.2);
  EXPECT_THROW((void)uniform_stretch<1>({0.0, 0.0, ConstantCurve{1}}, law), InputError);
}

/// dφ/dξ.
double cantilever_mode_slope(double xi) {
  constexpr double kappa = cantilever_wave_number;
  const double sigma = (std::cosh(kappa) + std::cos(kappa)) / (std::sinh(kappa) + std::sin(kappa));
  const double s = kappa * xi;
  return 0.5 * kappa * (std::sinh(s) + std::sin(s) - sigma * (std::cosh(s) - std::cos(s)));
}

TEST(CantileverMode, IsClampedAndFree) {
  EXPECT_EQ(cantilever_mode(0.0), 0.0);
  EXPECT_EQ(cantilever_mode_slope(0.0), 0.0);
  EXPECT_NEAR(cantilever_mode(1.0), 1.0, 1e-14);
  // no moment and no shear force at the free end
  const double step = 1e-3;
  const double slope_before = cantilever_mode_slope(1 - step), slope = cantilever_mode_slope(1.0);
  const double slope_after = cantilever_mode_slope(1 + step);
  EXPECT_NEAR((slope_after - slope_before) / (2 * step), 0.0, 1e-5);
  EXPECT_NEAR((slope_after - 2 * slope + slope_before) / (step * step), 0.0, 1e-4);
}

TEST(CantileverMode, SolvesTheBeamEquation) {
  // φ⁗ = κ⁴ φ, from third differences of the slope
  const double k4 = std::pow(cantilever_wave_number, 4), step = 1e-3;
  for (const double xi : {0.2, 0.5, 0.9}) {
    EXPECT_NEAR(cantilever_mode_slope(xi), difference(cantilever_mode, xi, step), 1e-10);
    const double fourth =
        (cantilever_mode_slope(xi + 2 * step) - 2 * cantilever_mode_slope(xi + step) +
         2 * cantilever_mode_slope(xi - step) - cantilever_mode_slope(xi - 2 * step)) /
        (2 * step * step * step);
    EXPECT_NEAR(fourth, k4 * cantilever_mode(xi), 1e-4);
  }
}

TEST(CantileverMode, TheWaveNumberSolvesItsEquation) {
  EXPECT_NEAR(std::cos(cantilever_wave_number) * std::cosh(cantilever_wave_number), -1.0, 1e-14);
}

}  // namespace
}  // namespace tlsph

// Numbers of the Neo-Hookean law that were found outside this program.
#include "tlsph/materials/any_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

constexpr double young = 2.5, poisson = 0.3;

Tensor<2> plane(double size, double xx, double xy, double yx, double yy) {
  Tensor<2> H;
  H << size * xx, size * xy, size * yx, size * yy;
  return H;
}

// Energies and transverse strains from (3.62) in 50-digit arithmetic, the free stretch by root
// finding.

TEST(NeoHookeanDigits, PlaneStrainAndPlaneStressAtTinyAndLargeStrain) {
  const NeoHookean<2, Assumption::strain> strain(lame(young, poisson));
  const NeoHookean<2, Assumption::stress> stress(lame(young, poisson));
  Tensor<2> tiny;
  tiny << 1.3e-7, -0.4e-7, 0.7e-7, -0.9e-7;
  const Tensor<2> large = plane(1, 0.8, -0.3, 0.4, -0.35);

  EXPECT_NEAR(strain.energy(tiny) / 2.56249990775642443e-14, 1.0, 2e-14);
  EXPECT_NEAR(stress.energy(tiny) / 2.51304938196644549e-14, 1.0, 2e-14);
  EXPECT_NEAR(strain.energy(large) / 0.721384400153926065, 1.0, 1e-14);
  EXPECT_NEAR(stress.energy(large) / 0.700477844028502185, 1.0, 1e-14);
  EXPECT_NEAR(stress.transverse_stretch(tiny) - 1, -1.71428530067056906e-8, 1e-15);
  EXPECT_NEAR(stress.transverse_stretch(large) - 1, -0.109787211910691355, 1e-15);
}

TEST(NeoHookeanDigits, OneDimensionAtTinyAndLargeStrain) {
  const NeoHookean<1, Assumption::strain> strain(lame(young, poisson));
  const NeoHookean<1, Assumption::stress> stress(lame(young, poisson));
  const Tensor<1> tiny(1.3e-7), large(0.8);

  EXPECT_NEAR(strain.energy(tiny) / 2.84374977114585905e-14, 1.0, 2e-14);
  EXPECT_NEAR(stress.energy(tiny) / 2.11249985860334919e-14, 1.0, 2e-14);
  EXPECT_NEAR(strain.energy(large) / 0.760897315072546178, 1.0, 1e-14);
  EXPECT_NEAR(stress.energy(large) / 0.604280449527815132, 1.0, 1e-14);
  EXPECT_NEAR(stress.transverse_stretch(tiny) - 1, -3.89999973129002286e-8, 1e-15);
  EXPECT_NEAR(stress.transverse_stretch(large) - 1, -0.172196541131346651, 1e-15);
}

/// P = (2μ+λ) x − (μ + 3λ/2) x² + O(x³) in 1D strain.
TEST(NeoHookeanDigits, StressAtAStrainOfOneBillionth) {
  const auto [lambda, mu] = lame(young, poisson);
  const NeoHookean<1> law({lambda, mu});
  const double x = 1e-9;
  const double expected = (2 * mu + lambda) * x - (mu + 1.5 * lambda) * x * x;
  EXPECT_NEAR(law.pk1(Tensor<1>(x))(0, 0) / expected, 1.0, 1e-15);
}

/// Energy and tangent of diagonal and sheared states free of transverse stress, in long double and
/// with y = ln s² as the unknown, in which neither small strains nor a vanishing s cancel.
template <int D>
struct Reference {
  using Long = long double;
  static constexpr int n = 3 - D;
  Long lambda, mu, e, log, y = 0, square = 0;  ///< square: H:H
  Long trace = 0;
  Long cof[D][D];

  Reference(const Lame& constants, const Tensor<D>& H)
      : lambda(constants.lambda), mu(constants.mu) {
    Long F[2][2] = {{1 + Long{H(0, 0)}, 0}, {0, 1}};
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        F[i][a] = (i == a ? 1 : 0) + Long{H(i, a)};
        square += Long{H(i, a)} * H(i, a);
      }
    for (int i = 0; i < D; ++i) trace += H(i, i);
    e = trace;
    if constexpr (D == 2) e += Long{H(0, 0)} * H(1, 1) - Long{H(0, 1)} * H(1, 0);
    log = std::log1p(e);
    if constexpr (D == 1) {
      cof[0][0] = 1;
    } else {
      cof[0][0] = F[1][1], cof[0][1] = -F[1][0], cof[1][0] = -F[0][1], cof[1][1] = F[0][0];
    }
    for (int k = 0; k < 300; ++k) {  // μ (eʸ − 1) + λ (ln J + n/2 y) = 0, by short Newton steps
      const Long residual = mu * std::expm1(y) + lambda * (log + Long{0.5} * n * y);
      const Long step = residual / (mu * std::exp(y) + Long{0.5} * n * lambda);
      y -= std::clamp<Long>(step, -1, 1);
    }
  }
  [[nodiscard]] Long energy() const {
    const Long volume = log + Long{0.5} * n * y;
    const Long distortion = trace + square / 2 + Long{0.5} * n * std::expm1(y) - volume;
    return mu * distortion + lambda / 2 * volume * volume;
  }
  [[nodiscard]] Tangent<D> tangent() const {
    const Long J = 1 + e, turned = mu * std::exp(y) / (J * J);
    const Long along = turned * lambda / (mu * std::exp(y) + Long{0.5} * n * lambda);
    Tangent<D> A;
    for (int row = 0; row < D * D; ++row)
      for (int column = 0; column < D * D; ++column) {
        const int i = row / D, a = row % D, j = column / D, b = column % D;
        A(row, column) =
            static_cast<double>((row == column ? mu : 0) + turned * cof[i][b] * cof[j][a] +
                                along * cof[i][a] * cof[j][b]);
      }
    return A;
  }
};

template <int D>
void expect_right_digits(double nu, const Tensor<D>& H) {
  const Lame constants = lame(young, nu);
  const NeoHookean<D, Assumption::stress> law(constants);
  const Reference<D> reference(constants, H);
  const Tangent<D> A = reference.tangent();
  EXPECT_LE((law.tangent(H) - A).norm(), 1e-12 * A.norm()) << "nu " << nu << ", H " << H;
  const auto s = static_cast<double>(std::exp(reference.y / 2));
  EXPECT_NEAR(law.transverse_stretch(H), s, 1e-12 * s) << "nu " << nu << ", H " << H;
  if (H.norm() < 1e-3) return;  // the reference loses digits of a small energy
  const auto energy = static_cast<double>(reference.energy());
  EXPECT_NEAR(law.energy(H), energy, 1e-12 * energy) << "nu " << nu << ", H " << H;
}

TEST(NeoHookeanDigits, AreKeptFromTinyStrainsToAVanishingThickness) {
  for (const double nu : {-0.5, 0.3, 0.49, 0.4999}) {
    for (const double size : {1e-11, 1e-7, 1e-3, 0.1, 0.9})
      expect_right_digits<2>(nu, plane(size, 0.8, -0.3, 0.4, -0.35));
    for (const double size : {1.0, 10.0, 1e2, 1e3, 1e4})
      expect_right_digits<2>(nu, plane(size, 1.0, 0.1, -0.2, 0.7));
    for (const double size : {1e-11, 1e-7, 1e-3, 0.5, 10.0, 1e3, 1e6, 1e9})
      expect_right_digits<1>(nu, Tensor<1>(size));
  }
}

/// P is the derivative of Ψ on either side of where s² is called small, and far beyond.
TEST(NeoHookeanDigits, StressIsTheSlopeOfTheEnergy) {
  const NeoHookean<2, Assumption::stress> law(lame(young, 0.49));
  for (const double size : {0.4, 0.6, 1.0, 10.0, 1e3}) {
    const Tensor<2> H = plane(size, 1.0, 0.1, -0.2, 0.7);
    TensorOf<2, Dual<double, 4>> moved;
    for (int k = 0; k < 4; ++k)
      moved(k / 2, k % 2) = dual<4>(H(k / 2, k % 2), [&](int m) { return m == k ? 1.0 : 0.0; });
    const Dual<double, 4> energy = law.text().energy(moved);
    const Tensor<2> P = law.pk1(H);
    for (int k = 0; k < 4; ++k)
      EXPECT_NEAR(energy.change[k], P(k / 2, k % 2), 1e-12 * P.norm()) << "size " << size;
  }
}

TEST(NeoHookeanDigits, HandNumbers) {
  const NeoHookean<2> law({2.0, 3.0});                // λ = 2, μ = 3
  const Tensor<2> P = law.pk1(plane(1, 1, 0, 0, 0));  // F = diag(2, 1), J = 2
  EXPECT_NEAR(P(0, 0), 3 * (2 - 0.5) + 2 * std::log(2.0) / 2, 1e-15);
  EXPECT_NEAR(P(1, 1), 2 * std::log(2.0), 1e-15);
  EXPECT_EQ(P(0, 1), 0.0);
  EXPECT_NEAR(law.transverse_stress(plane(1, 1, 0, 0, 0)), std::log(2.0), 1e-15);

  const Tensor<2> sheared = law.pk1(plane(1, 0, 0.5, 0, 0));  // simple shear, J = 1
  EXPECT_NEAR(sheared(0, 1), 1.5, 1e-15);
  EXPECT_NEAR(sheared(1, 0), 1.5, 1e-15);
  EXPECT_NEAR(sheared(0, 0), 0.0, 1e-15);
}

TEST(NeoHookeanDigits, NoNumberWithoutVolume) {
  const NeoHookean<2, Assumption::strain> strain(lame(young, poisson));
  const NeoHookean<2, Assumption::stress> stress(lame(young, poisson));
  for (const double xx : {-1.0, -1.5}) {  // J = 0 and J < 0
    const Tensor<2> H = plane(1, xx, 0.0, 0.0, 0.2);
    EXPECT_TRUE(strain.pk1(H).array().isNaN().all()) << xx;
    EXPECT_TRUE(stress.pk1(H).array().isNaN().all()) << xx;
    EXPECT_TRUE(std::isnan(strain.energy(H))) << xx;
    EXPECT_TRUE(std::isnan(stress.energy(H))) << xx;
  }
}

/// The free stretch must be found however far the body is deformed and whatever the
/// compressibility.
TEST(NeoHookeanFreeStretch, SolvesItsEquationEverywhere) {
  for (const double nu : {0.0, 0.3, 0.49, 0.4999}) {
    const auto [lambda, mu] = lame(young, nu);
    const NeoHookean<1, Assumption::stress> bar({lambda, mu});
    for (const double H : {-0.999999, -0.99, -0.5, -1e-3, 1e-3, 1.0, 49.0, 1e6}) {
      const double s = bar.transverse_stretch(Tensor<1>(H));
      const double volume = std::log(1 + H);
      const double residual = mu * (s - 1) * (s + 1) + lambda * (volume + 2 * std::log(s));
      const double slope = 2 * (mu * s * s + lambda);  // by ds/s
      EXPECT_NEAR(residual / slope, 0.0, 2e-15 * std::max(1.0, std::abs(volume)))
          << "nu " << nu << ", H " << H;
    }
  }
}

/// With λ < 0, μ(s² − 1) + λ ln(F s²) is least at s² = −λ/μ; at ν = −1/2 that is 1/2 (μ = E, λ =
/// −E/2) and the least value is zero at F = 2/e: no free stretch below.
TEST(NeoHookeanFreeStretch, EndsForAuxeticBodiesInCompression) {
  const NeoHookean<1, Assumption::stress> bar(lame(young, -0.5));
  const double last = 2 / std::exp(1.0);
  EXPECT_NEAR(bar.transverse_stretch(Tensor<1>(1.0001 * last - 1)), std::sqrt(0.5), 0.02);
  EXPECT_TRUE(std::isnan(bar.transverse_stretch(Tensor<1>(0.9999 * last - 1))));
  EXPECT_TRUE(std::isnan(bar.pk1(Tensor<1>(-0.99))(0, 0)));
}

/// dP/dF = μ(1 + 1/F²) + λ(1 − ln F)/F² in 1D strain is negative exactly for 3.63 < F < 6.40 at
/// ν = 0.49, and never at ν = 0.48.
TEST(NeoHookeanStability, LosesHyperbolicityInOneDimensionalStrain) {
  const auto [lambda, mu] = lame(young, 0.49);
  const NeoHookean<1> law({lambda, mu});
  for (const double F : {1.0, 2.0, 3.62, 3.64, 5.0, 6.39, 6.41, 9.0}) {
    const Tangent<1> A = law.tangent(Tensor<1>(F - 1));
    const double expected = mu * (1 + 1 / (F * F)) + lambda * (1 - std::log(F)) / (F * F);
    EXPECT_NEAR(A(0, 0), expected, 1e-13 * lambda);
    EXPECT_EQ(is_hyperbolic<1>(A), F < 3.63 || F > 6.40) << "F " << F;
  }
  const NeoHookean<1> softer(lame(young, 0.48));
  for (double F = 1; F < 10; F += 0.05)
    EXPECT_TRUE(is_hyperbolic<1>(softer.tangent(Tensor<1>(F - 1)))) << "F " << F;
}

/// At ν = 0.49 a plane-strain sheet of lateral stretch 2 loses hyperbolicity at λ₁ = 1.45.
TEST(NeoHookeanStability, LosesHyperbolicityInPlaneStrain) {
  const NeoHookean<2> law(lame(young, 0.49));
  EXPECT_TRUE(is_hyperbolic<2>(law.tangent(plane(1, 0.44, 0, 0, 1.0))));
  EXPECT_FALSE(is_hyperbolic<2>(law.tangent(plane(1, 0.46, 0, 0, 1.0))));
}

}  // namespace
}  // namespace tlsph

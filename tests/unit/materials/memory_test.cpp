/// Laws that remember what a point has gone through, against solutions by hand.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "memory_laws.hpp"

namespace tlsph {
namespace {

static_assert(ElasticLaw<Law<VonMises<1>>, 1> && ElasticLaw<Law<VonMises<2>>, 2>);
static_assert(!Remembers<laws::NeoHookean<2, Assumption::strain>>);
static_assert(sizeof(NeoHookean<2>) == 2 * sizeof(double));

/// A material point on its way.
template <class L>
struct Point {
  const L& law;
  std::vector<double> memory = std::vector<double>(static_cast<std::size_t>(law.memory()), 0.0);

  /// The stress at H after dt.
  template <class H>
  H step(const H& gradient, double dt) {
    std::vector<double> now(memory.size());
    const H P = law.at({memory.data(), dt}).pk1(gradient, now.data());
    memory = now;
    return P;
  }
  [[nodiscard]] decltype(auto) here() const { return law.at({memory.data(), 0.0}); }
};

/// Strains at the ends of straight pieces, each in `steps` of equal time; work ∫ P dH by the
/// trapezoidal rule. Calls look(k) at the end of the k-th.
template <class L, class Look>
double walk(Point<L>& point, const std::vector<double>& ends, int steps, double time,
            const Look& look) {
  double strain = 0.0, stress = 0.0, work = 0.0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const double change = (ends[k] - strain) / steps;
    for (int n = 1; n <= steps; ++n) {
      const double next = point.step(Tensor<1>(strain + n * change), time / steps)(0, 0);
      work += 0.5 * (stress + next) * change;
      stress = next;
    }
    strain = ends[k];
    look(k, stress);
  }
  return work;
}

constexpr double bulk = soft_metal[0], shear = soft_metal[1], yield = soft_metal[2],
                 hardening = soft_metal[3];
constexpr double modulus = bulk + 4 * shear / 3;

/// In 1D strain q = |2μ ε − 3μ εᵖ| with εᵖ that along the axis. Loaded to ε₁ from σ_y: α₁ = εᵖ₁ =
/// (2μ ε₁ − σ_y)/(3μ + K). Back to ε₂: 3μ (εᵖ₁ − β) − 2μ ε₂ = σ_y + K (α₁ + β). σ = (κ + 4/3 μ) ε
/// − 2μ εᵖ.
TEST(VonMises, FollowsTheExactPathThereAndBack) {
  const Law<VonMises<1>> law{std::span<const double>(soft_metal)};
  const double there = 5e-3, back = -4e-3;
  const double first = (2 * shear * there - yield) / (3 * shear + hardening);
  const double second =
      (3 * shear * first - 2 * shear * back - yield - hardening * first) / (3 * shear + hardening);
  ASSERT_GT(second, 0.0);
  for (const int steps : {1, 7, 1000}) {
    Point<Law<VonMises<1>>> point{law};

    const double work = walk(point, {there, back}, steps, 1.0, [&](std::size_t k, double stress) {
      const double plastic = k == 0 ? first : first - second;
      EXPECT_NEAR(stress, modulus * (k == 0 ? there : back) - 2 * shear * plastic, 1e-10);
      EXPECT_NEAR(point.memory[0], plastic, 1e-16);
      EXPECT_NEAR(point.memory[4], k == 0 ? first : first + second, 1e-16);
    });

    EXPECT_NEAR(point.here().dissipated(), yield * (first + second), 1e-12);
    if (steps == 1000) {
      EXPECT_NEAR(point.here().energy(Tensor<1>(back)) + point.here().dissipated(), work,
                  1e-4 * work);
    }
  }
}

/// Simple shear: q = √3 |τ|, so α = (√3 μ γ − σ_y)/(3μ + K) and √3 τ = σ_y + K α.
TEST(VonMises, YieldsInShear) {
  const Law<VonMises<2>> law{std::span<const double>(soft_metal)};
  Point<Law<VonMises<2>>> point{law};
  Tensor<2> H = Tensor<2>::Zero();
  H(0, 1) = 1e-3;  // σ_y/(√3 μ) = 1.15e-3
  EXPECT_NEAR(point.step(H, 1.0)(1, 0), shear * 1e-3, 1e-12);
  H(0, 1) = 4e-3;
  const double alpha = (std::sqrt(3.0) * shear * 4e-3 - yield) / (3 * shear + hardening);

  const Tensor<2> P = point.step(H, 1.0);

  EXPECT_NEAR(P(0, 1), (yield + hardening * alpha) / std::sqrt(3.0), 1e-10);
  EXPECT_EQ(P(0, 1), P(1, 0));
  EXPECT_NEAR(P(0, 0), 0.0, 1e-12);
}

/// The tangent of a step is its derivative, also where the point flows; what is sudden after that
/// is elastic.
TEST(VonMises, TangentsAreThoseOfTheStepAndOfASuddenChange) {
  const Law<VonMises<2>> law{std::span<const double>(soft_metal)};
  const GivenLaw<2, true> given(law);
  Point<Law<VonMises<2>>> point{law};
  Tensor<2> H, dH;
  H << 3e-3, 1e-3, -2e-3, 4e-4;
  dH << 0.3, -0.8, 0.5, 0.7;
  (void)point.step(Tensor<2>(0.8 * H), 1.0);
  const Past past{point.memory.data(), 1.0};
  const double h = 1e-7;
  const Tensor<2> difference =
      (law.at(past).pk1(H + h * dH) - law.at(past).pk1(H - h * dH)) / (2 * h);

  EXPECT_LE((law.at(past).dpk1(H, dH) - difference).norm(), 1e-7 * difference.norm());
  EXPECT_EQ(given.at(past).tangent(H), law.at(past).tangent(H));
  const Tensor<2> flowing = law.at(past).dpk1(H, dH);
  (void)point.step(H, 1.0);
  const Tangent<2> elastic = law.tangent(Tensor<2>::Zero());
  EXPECT_LE((point.here().tangent(H) - elastic).norm(), 1e-12 * elastic.norm());
  EXPECT_GT((point.here().dpk1(H, dH) - flowing).norm(), 0.05 * flowing.norm());
}

/// A ramp of rate r over T, then rest for T: σ = E_∞ ε + E r τ (1 − e^{−T/τ}), which decays.
TEST(ViscousBar, RelaxesAsTheExactSolution) {
  const std::array<double, 3> constants = {2e6, 3e6, 0.4};
  const Law<ViscousBar> law{std::span<const double>(constants)};
  const double strain = 1e-3, time = 0.5;
  const double left = std::exp(-time / constants[2]);
  const double excess = constants[1] * strain / time * constants[2] * (1 - left);
  for (const int steps : {1, 400}) {
    Point<Law<ViscousBar>> point{law};

    const double work =
        walk(point, {strain, strain}, steps, time, [&](std::size_t k, double stress) {
          EXPECT_NEAR(stress, constants[0] * strain + excess * (k == 0 ? 1 : left), 1e-9);
        });

    EXPECT_GT(point.here().dissipated(), 0.0);
    if (steps == 400) {
      EXPECT_NEAR(point.here().energy(Tensor<1>(strain)) + point.here().dissipated(), work,
                  1e-6 * work);
    }
  }
}

/// A sudden change is elastic with both springs; with time, the viscous one gives way.
TEST(ViscousBar, IsStiffestSuddenly) {
  const std::array<double, 3> constants = {2e6, 3e6, 0.4};
  const Law<ViscousBar> law{std::span<const double>(constants)};
  const std::array<double, 3> memory = {1e-3, 4e-4, 0.0};
  const Tensor<1> H(1.1e-3);
  EXPECT_NEAR(law.at({memory.data(), 0.0}).pk1(H)(0, 0), 2e6 * 1.1e-3 + 3e6 * 7e-4, 1e-9);
  EXPECT_DOUBLE_EQ(law.at({memory.data(), 0.0}).tangent(H)(0, 0), 5e6);
  const double share = 0.4 * (1 - std::exp(-0.25)) / 0.1;
  EXPECT_NEAR(law.at({memory.data(), 0.1}).tangent(H)(0, 0), 2e6 + 3e6 * share, 1e-8);
}

/// P = E ε₀ on the way out for b = 1; back along the secant; what was lost is the area between.
TEST(DamagedBar, LosesStiffnessForGood) {
  const std::array<double, 3> constants = {4e6, 1e-3, 1.0};
  const Law<DamagedBar> law{std::span<const double>(constants)};
  const GivenLaw<1, true> given(law);
  Point<GivenLaw<1, true>> point{given};

  const double work = walk(point, {1e-3, 4e-3, 0.0}, 50, 1.0, [&](std::size_t k, double stress) {
    EXPECT_NEAR(stress, k < 2 ? 4e3 : 0.0, 1e-9);
  });

  EXPECT_NEAR(point.here().tangent(Tensor<1>(0.0))(0, 0), 1e6, 1e-6);
  EXPECT_NEAR(point.here().dissipated(), 0.5 * 4e3 * 3e-3, 1e-12);
  EXPECT_NEAR(point.here().energy(Tensor<1>(0.0)) + point.here().dissipated(), work, 1e-10 * work);
}

}  // namespace
}  // namespace tlsph

// What holds for every law, dimension and assumption.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/stress.hpp"

namespace tlsph {
namespace {

constexpr Lame constants{1.4423076923076923, 0.96153846153846154};  // E = 2.5, ν = 0.3

template <template <int, Assumption> class L, int D, Assumption A>
struct Case {
  using Law = L<D, A>;
  using Law3 = L<3, Assumption::strain>;
  static constexpr int dimension = D;
  static constexpr Assumption assumption = A;
};

template <class C>
class LawTest : public testing::Test {
 protected:
  const typename C::Law law{constants};

  /// A gradient without symmetry; det(I + size × it) > 0 for size ≤ 1.
  static Tensor<C::dimension> gradient(double size) {
    Eigen::Matrix3d H;
    H << 0.8, -0.3, 0.2, 0.4, -0.35, 0.15, -0.1, 0.25, 0.3;
    return size * H.topLeftCorner<C::dimension, C::dimension>();
  }
};

constexpr auto strain_assumed = Assumption::strain;
constexpr auto stress_assumed = Assumption::stress;
using Cases = testing::Types<
    Case<LinearElastic, 1, strain_assumed>, Case<LinearElastic, 1, stress_assumed>,
    Case<LinearElastic, 2, strain_assumed>, Case<LinearElastic, 2, stress_assumed>,
    Case<LinearElastic, 3, strain_assumed>, Case<StVenantKirchhoff, 1, strain_assumed>,
    Case<StVenantKirchhoff, 1, stress_assumed>, Case<StVenantKirchhoff, 2, strain_assumed>,
    Case<StVenantKirchhoff, 2, stress_assumed>, Case<StVenantKirchhoff, 3, strain_assumed>,
    Case<NeoHookean, 1, strain_assumed>, Case<NeoHookean, 1, stress_assumed>,
    Case<NeoHookean, 2, strain_assumed>, Case<NeoHookean, 2, stress_assumed>,
    Case<NeoHookean, 3, strain_assumed>>;
TYPED_TEST_SUITE(LawTest, Cases);

/// Fourth-order central difference of f along component (i, a) of H.
template <class F, int D>
std::invoke_result_t<F, Tensor<D>> difference(F f, const Tensor<D>& H, int i, int a, double step) {
  using Value = std::invoke_result_t<F, Tensor<D>>;
  const auto at = [&](double x) {
    Tensor<D> moved = H;
    moved(i, a) += x;
    return f(moved);
  };
  const Value near_change = at(step) - at(-step);
  const Value far_change = at(2 * step) - at(-2 * step);
  return (8 * near_change - far_change) / (12 * step);
}

TYPED_TEST(LawTest, StressIsTheDerivativeOfTheEnergy) {
  constexpr int D = TypeParam::dimension;
  for (const double size : {1e-9, 1e-7, 1e-3, 0.1, 1.0}) {
    const Tensor<D> H = this->gradient(size);
    const Tensor<D> P = this->law.pk1(H);
    const double step = size < 0.1 ? 0.25 * size : 1e-3;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        const double expected = difference(
            [&](const Tensor<D>& moved) { return this->law.energy(moved); }, H, i, a, step);
        EXPECT_NEAR(P(i, a), expected, 1e-9 * P.norm()) << "size " << size << " " << i << a;
      }
  }
}

TYPED_TEST(LawTest, TangentIsTheDerivativeOfTheStress) {
  constexpr int D = TypeParam::dimension;
  for (const double size : {0.0, 1e-9, 1e-3, 0.1, 1.0}) {
    const Tensor<D> H = this->gradient(size);
    const Tangent<D> A = this->law.tangent(H);
    for (int j = 0; j < D; ++j)
      for (int b = 0; b < D; ++b) {
        const Tensor<D> expected =
            difference([&](const Tensor<D>& moved) { return this->law.pk1(moved); }, H, j, b, 1e-3);
        for (int i = 0; i < D; ++i)
          for (int a = 0; a < D; ++a)
            EXPECT_NEAR(A(i * D + a, j * D + b), expected(i, a), 1e-9 * A.norm())
                << "size " << size << " " << i << a << j << b;
      }
  }
}

TYPED_TEST(LawTest, TangentIsSymmetricAndActsAsItsProduct) {
  constexpr int D = TypeParam::dimension;
  const Tensor<D> H = this->gradient(0.7);
  const Tensor<D> dH = this->gradient(-0.2).transpose();
  const Tangent<D> A = this->law.tangent(H);
  EXPECT_LE((A - A.transpose()).norm(), 1e-14 * A.norm());

  const Tensor<D> action = this->law.dpk1(H, dH);
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) {
      double sum = 0;
      for (int j = 0; j < D; ++j)
        for (int b = 0; b < D; ++b) sum += A(i * D + a, j * D + b) * dH(j, b);
      EXPECT_NEAR(action(i, a), sum, 1e-14 * A.norm());
    }
}

/// A text of which a tangent is known by its stress only.
template <class Text>
struct StressOnly {
  const Text& text;
  template <class H, class Good>
  auto stress(const H& at, Good& good) const {
    return text.stress(at, good);
  }
};

/// Dual numbers through the energy give the stress, through the stress the tangent.
TYPED_TEST(LawTest, DualNumbersDifferentiateItsText) {
  constexpr int D = TypeParam::dimension;
  const auto& text = this->law.text();
  for (const double size : {0.0, 1e-9, 1e-3, 0.1, 1.0}) {
    const Tensor<D> H = this->gradient(size);
    const Tensor<D> P = this->law.pk1(H);
    const Tangent<D> A = this->law.tangent(H);
    TensorOf<D, double> at;
    TensorOf<D, Dual<double, D * D>> moved;
    for (int k = 0; k < D * D; ++k) {
      at(k / D, k % D) = H(k / D, k % D);
      moved(k / D, k % D) = dual<D * D>(H(k / D, k % D), [&](int n) { return n == k ? 1.0 : 0.0; });
    }
    const auto energy = text.energy(moved);
    const auto tangent = tangent_of<D>(StressOnly<std::decay_t<decltype(text)>>{text}, at);
    EXPECT_NEAR(energy.value, this->law.energy(H), 1e-15 * energy.value);
    for (int row = 0; row < D * D; ++row) {
      EXPECT_NEAR(energy.change[row], P(row / D, row % D), 1e-13 * P.norm()) << size;
      for (int column = 0; column < D * D; ++column)
        EXPECT_NEAR(tangent(row, column), A(row, column), 1e-14 * A.norm()) << size;
    }
  }
}

TYPED_TEST(LawTest, TheReferenceIsFreeOfStressAndEnergy) {
  constexpr int D = TypeParam::dimension;
  const Tensor<D> zero = Tensor<D>::Zero();
  EXPECT_EQ(this->law.energy(zero), 0.0);
  EXPECT_EQ(this->law.pk1(zero).norm(), 0.0);
  EXPECT_EQ(this->law.transverse_stress(zero), 0.0);
  EXPECT_EQ(this->law.transverse_stretch(zero), 1.0);
}

TYPED_TEST(LawTest, IsLinearElasticForSmallStrain) {
  constexpr int D = TypeParam::dimension;
  const LinearElastic<D, TypeParam::assumption> linear{constants};
  const Tensor<D> H = this->gradient(1e-9);
  EXPECT_NEAR(this->law.energy(H) / linear.energy(H), 1.0, 5e-9);
  EXPECT_LE((this->law.pk1(H) - linear.pk1(H)).norm(), 5e-9 * linear.pk1(H).norm());
  EXPECT_LE((this->law.tangent(Tensor<D>::Zero()) - linear.tangent(Tensor<D>::Zero())).norm(),
            1e-14 * linear.tangent(H).norm());
}

/// The laws of fewer dimensions are the three-dimensional one with the missing stretches filled in.
TYPED_TEST(LawTest, IsTheThreeDimensionalLawWithTheMissingStretches) {
  constexpr int D = TypeParam::dimension;
  const typename TypeParam::Law3 law3{constants};
  for (const double size : {1e-9, 1e-4, 0.3, 1.0}) {
    const Tensor<D> H = this->gradient(size);
    const double stretch = this->law.transverse_stretch(H);
    Tensor<3> H3 = Tensor<3>::Zero();
    H3.template topLeftCorner<D, D>() = H;
    for (int missing = D; missing < 3; ++missing) H3(missing, missing) = stretch - 1;

    const Tensor<D> P = this->law.pk1(H);
    const Tensor<3> P3 = law3.pk1(H3);
    const Tensor<3> sigma3 = cauchy<3>(law3, H3, P3);
    // stretch − 1 is known to the rounding of 1
    const double rounding = 1e-15 + 1e-14 * P.norm();

    EXPECT_LE((P3.template topLeftCorner<D, D>() - P).norm(), rounding) << "size " << size;
    EXPECT_NEAR(law3.energy(H3), this->law.energy(H), rounding * size) << "size " << size;
    const Tensor<D> sigma = cauchy<D>(this->law, H, P);
    EXPECT_LE((sigma3.template topLeftCorner<D, D>() - sigma).norm(), rounding);
    for (int missing = D; missing < 3; ++missing) {
      EXPECT_NEAR(sigma3(missing, missing), this->law.transverse_stress(H), rounding);
      if (TypeParam::assumption == Assumption::stress) {
        EXPECT_NEAR(P3(missing, missing), 0.0, rounding);
      }
    }
  }
}

template <class C>
class RotatedLaw : public LawTest<C> {};
using FiniteStrainCases =
    testing::Types<Case<StVenantKirchhoff, 2, strain_assumed>,
                   Case<StVenantKirchhoff, 2, stress_assumed>,
                   Case<StVenantKirchhoff, 3, strain_assumed>, Case<NeoHookean, 2, strain_assumed>,
                   Case<NeoHookean, 2, stress_assumed>, Case<NeoHookean, 3, strain_assumed>>;
TYPED_TEST_SUITE(RotatedLaw, FiniteStrainCases);

TYPED_TEST(RotatedLaw, DoesNotFeelARotationAfterwards) {
  constexpr int D = TypeParam::dimension;
  Tensor<D> Q = Tensor<D>::Identity();
  Q(0, 0) = std::cos(1.1);
  Q(0, 1) = -std::sin(1.1);
  Q(1, 0) = std::sin(1.1);
  Q(1, 1) = std::cos(1.1);
  const Tensor<D> H = this->gradient(0.9);
  const Tensor<D> turned = Q * (Tensor<D>::Identity() + H) - Tensor<D>::Identity();

  const double energy = this->law.energy(H);
  const Tensor<D> P = this->law.pk1(H);
  EXPECT_NEAR(this->law.energy(turned), energy, 1e-14 * std::max(1.0, energy));
  EXPECT_LE((this->law.pk1(turned) - Q * P).norm(), 1e-14 * std::max(1.0, P.norm()));
  EXPECT_LE(this->law.pk1(Q - Tensor<D>::Identity()).norm(), 1e-14);
}

}  // namespace
}  // namespace tlsph

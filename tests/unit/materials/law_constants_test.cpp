// A law with constants of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/materials/any_law.hpp"

namespace tlsph {
namespace {

/// Linear elasticity of a cubic crystal along its axes: three constants.
template <int D, Assumption A>
class Cubic {
 public:
  static constexpr int dimension = D;
  static constexpr std::string_view name = "cubic";
  static constexpr std::array<LawConstant, 3> keys = {
      {{"c11", "Pa", above(0.0), "stiffness along an axis"},
       {"c12", "Pa", above(0.0), "stiffness across"},
       {"c44", "Pa", above(0.0), "shear stiffness"}}};
  static constexpr bool small_strain = true;

  explicit Cubic(std::span<const double> values)
      : along_(values[0]), across_(values[1]), shear_(values[2]) {}

  template <class R>
  [[nodiscard]] R energy(const TensorOf<D, R>& H) const {
    Mask<R> good{};
    const TensorOf<D, R> P = stress(H, good);
    R sum = 0.5 * P(0, 0) * H(0, 0);
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        if (i + a > 0) sum = sum + 0.5 * P(i, a) * H(i, a);
    return sum;
  }
  template <class R>
  [[nodiscard]] TensorOf<D, R> stress(const TensorOf<D, R>& H, Mask<R>&) const {
    const R volume = trace<D>(H);
    TensorOf<D, R> P;
    for (int i = 0; i < D; ++i) {
      P(i, i) = across_ * volume + (along_ - across_) * H(i, i);
      for (int a = i + 1; a < D; ++a) P(i, a) = P(a, i) = shear_ * (H(i, a) + H(a, i));
    }
    return P;
  }
  [[nodiscard]] double transverse_stretch(const TensorOf<D, double>&) const { return 1.0; }
  [[nodiscard]] double transverse_stress(const TensorOf<D, double>& H) const {
    return across_ * trace<D>(H);
  }
  [[nodiscard]] double margin(const TensorOf<D, double>&) const { return 1.0; }

 private:
  double along_, across_, shear_;
};

using List = laws::List<Cubic<2, Assumption::strain>, Cubic<2, Assumption::stress>>;
constexpr std::array<double, 3> iron = {230e9, 135e9, 117e9};

TEST(LawConstants, FollowFromTheListOfLaws) {
  EXPECT_THAT(laws::names(List()), testing::ElementsAre("cubic"));
  const auto constants = laws::constants(List());
  ASSERT_EQ(constants.size(), 1U);
  ASSERT_EQ(constants[0].size(), 3U);
  EXPECT_EQ(constants[0][2].name, "c44");
  EXPECT_EQ(constants[0][2].range.text(), "> 0");
}

TEST(LawConstants, MakeALawOfMoreThanTwo) {
  using Crystal = Law<Cubic<2, Assumption::strain>>;
  static_assert(ElasticLaw<Crystal, 2>);
  const Crystal law{std::span<const double>(iron)};

  const Tangent<2> A = law.tangent(Tensor<2>::Zero());

  EXPECT_DOUBLE_EQ(A(0, 0), iron[0]);
  EXPECT_DOUBLE_EQ(A(0, 3), iron[1]);
  EXPECT_DOUBLE_EQ(A(1, 2), iron[2]);
  EXPECT_DOUBLE_EQ(law.energy(Tensor<2>::Identity()), iron[0] + iron[1]);
}

TEST(LawConstants, GiveTheModuliAtRest) {
  using Crystal = Law<Cubic<3, Assumption::strain>>;
  const Lame steel = lame(200e9, 0.3);
  const std::array<double, 3> isotropic = {steel.lambda + 2 * steel.mu, steel.lambda, steel.mu};

  for (const Moduli& moduli : {moduli_at_rest(Crystal{std::span<const double>(isotropic)}),
                               moduli_at_rest(LawName::neo_hookean, std::array{200e9, 0.3})}) {
    EXPECT_NEAR(moduli.young, 200e9, 1e-3);
    EXPECT_NEAR(moduli.poisson, 0.3, 1e-14);
    EXPECT_NEAR(moduli.shear, steel.mu, 1e-3);
  }
}

TEST(LawConstants, AreCheckedByNumberAndRange) {
  const auto make = [](const std::vector<double>& values) {
    (void)make_law<2>(LawName::neo_hookean, Assumption::strain, values);
  };
  make({1e6, 0.3});
  EXPECT_THROW(make({1e6}), InputError);
  EXPECT_THROW(make({1e6, 0.3, 0.1}), InputError);
  EXPECT_THROW(make({1e6, 0.5}), InputError);
  EXPECT_THROW(make({0.0, 0.3}), InputError);
}

}  // namespace
}  // namespace tlsph

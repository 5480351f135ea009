/// `is_hyperbolic` answers most questions by a sum of squares; it must never differ from the sign
/// of the smallest eigenvalue.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

/// R(left) diag(first, second) R(right) − I.
Tensor<2> gradient(double first, double second, double left, double right) {
  const auto rotation = [](double angle) {
    Tensor<2> R;
    R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return R;
  };
  Tensor<2> stretch = Tensor<2>::Zero();
  stretch(0, 0) = first;
  stretch(1, 1) = second;
  return rotation(left) * stretch * rotation(right) - Tensor<2>::Identity();
}

TEST(Hyperbolicity, IsThePositiveSignOfTheSmallestEigenvalue) {
  for (const auto assumption : {Assumption::strain, Assumption::stress})
    for (const auto name :
         {LawName::linear_elastic, LawName::st_venant_kirchhoff, LawName::neo_hookean})
      for (const double poisson : {-0.5, 0.0, 0.3, 0.49}) {
        const auto law = make_law<2>(name, assumption, 2e6, poisson);
        int lost = 0;
        for (double first = 0.3; first < 8; first *= 1.21)
          for (double second = 0.3; second < 8; second *= 1.21) {
            const auto A = tangent<2>(law, gradient(first, second, 0.4, 1.1));
            const double eigenvalue = smallest_acoustic_eigenvalue<2>(A);
            if (std::isnan(eigenvalue) || std::abs(eigenvalue) < 1e-6) continue;
            lost += eigenvalue < 0 ? 1 : 0;
            EXPECT_EQ(is_hyperbolic<2>(A), eigenvalue > 0)
                << static_cast<int>(name) << ", " << poisson << ", " << first << ", " << second;
          }
        const bool plane_strain = assumption == Assumption::strain;
        if (name == LawName::st_venant_kirchhoff ||
            (name == LawName::neo_hookean && plane_strain && poisson == 0.49)) {
          EXPECT_GT(lost, 0);
        }
        if (name == LawName::linear_elastic) {
          EXPECT_EQ(lost, 0);
        }
      }
}

/// Plane-strain Neo-Hookean: ρc² = μ + (2μ − λ ln J − μ + λ)/λ_i² at its least along the stretch
/// λ_i. With λ₂ = 2 that vanishes at the λ₁ below.
TEST(Hyperbolicity, IsLostInPlaneStrainWhereTheFormulaSays) {
  const Lame constants = lame(2e6, 0.49);
  const NeoHookean<2> law(constants);
  const auto formula = [&](double first, double second) {
    const double rest = constants.mu + constants.lambda * (1 - std::log(first * second));
    const double shorter = std::min(first, second), longer = std::max(first, second);
    return constants.mu + rest / std::pow(rest > 0 ? longer : shorter, 2);
  };
  for (const double first : {1.0, 1.3, 1.44, 1.46, 2.0, 3.0, 5.0}) {
    const auto A = law.tangent(gradient(first, 2.0, 0.0, 0.0));
    EXPECT_NEAR(smallest_acoustic_eigenvalue<2>(A), std::min(constants.mu, formula(first, 2.0)),
                1e-9 * constants.lambda)
        << first;
  }
}

}  // namespace
}  // namespace tlsph

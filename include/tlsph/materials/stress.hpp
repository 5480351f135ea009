#pragma once
/// \file
/// Stress in the deformed configuration and its scalar measures.

#include <cmath>

#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/kinematics.hpp"

namespace tlsph {

/// Cauchy stress σ = P Fᵀ/J [Pa] of the model's D directions, J that of the three-dimensional body.
/// Small-strain laws do not tell reference and deformed body apart: σ = P.
template <int D, ElasticLaw<D> Law>
[[nodiscard]] Tensor<D> cauchy(const Law& law, const Tensor<D>& H, const Tensor<D>& P) {
  if constexpr (Law::small_strain) {
    return P;
  } else {
    const double stretch = law.transverse_stretch(H);
    double J = 1 + volume_change<D>(H);
    for (int missing = D; missing < 3; ++missing) J *= stretch;
    return (P + P * H.transpose()) / J;
  }
}

/// The same for whichever law it is.
template <int D>
[[nodiscard]] Tensor<D> cauchy(const AnyLaw<D>& any, const Tensor<D>& H, const Tensor<D>& P,
                               const Past& past = {}) {
  return std::visit([&](const auto& law) { return cauchy<D>(law.at(past), H, P); }, any);
}

/// Cauchy stress in the missing directions [Pa]; zero in 1D stress and plane stress.
template <int D>
[[nodiscard]] double transverse_stress(const AnyLaw<D>& any, const Tensor<D>& H,
                                       const Past& past = {}) {
  return std::visit([&](const auto& law) { return law.at(past).transverse_stress(H); }, any);
}

/// Pressure −tr σ/3 [Pa], compression positive; `transverse` is the stress of the missing
/// directions.
template <int D>
[[nodiscard]] double pressure(const Tensor<D>& sigma, double transverse) {
  return -(sigma.trace() + (3 - D) * transverse) / 3;
}

/// Von Mises stress √(3/2 s:s) [Pa], s the deviator of the three-dimensional Cauchy stress.
template <int D>
[[nodiscard]] double von_mises(const Tensor<D>& sigma, double transverse) {
  const double p = pressure<D>(sigma, transverse);
  const Tensor<D> deviator = sigma + p * Tensor<D>::Identity();
  const double missing = transverse + p;
  return std::sqrt(1.5 * (deviator.squaredNorm() + (3 - D) * missing * missing));
}

}  // namespace tlsph

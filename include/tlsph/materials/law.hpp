#pragma once
/// \file
/// Elastic laws. A law is a small struct of parameters with three pure functions of the displacement
/// gradient H = ∂u/∂X (so F = I + H; passing H keeps full precision at strains of 1e-7):
/// energy density Ψ [J/m³], first Piola–Kirchhoff stress P = ∂Ψ/∂F [Pa] and tangent A = ∂P/∂F [Pa].

#include <concepts>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// The kinematic assumption behind the missing dimensions: no strain there (1D strain, plane strain)
/// or no stress there (1D stress, plane stress).
enum class Assumption { strain, stress };

/// A_(ia)(jb) = ∂P_ia/∂F_jb, rows and columns numbered i*D + a.
template <int D>
using Tangent = Eigen::Matrix<double, D * D, D * D>;

template <class L, int D>
concept ElasticLaw = requires(const L& law, const Tensor<D>& H) {
  { law.energy(H) } -> std::same_as<double>;
  { law.pk1(H) } -> std::same_as<Tensor<D>>;
  { law.tangent(H) } -> std::same_as<Tangent<D>>;
};

}  // namespace tlsph

#pragma once
/// \file
/// Elastic laws. A law is a small struct of parameters with pure functions of the displacement
/// gradient H = ∂u/∂X (so F = I + H; passing H keeps full precision at strains of 1e-9): energy
/// density Ψ [J/m³], first Piola–Kirchhoff stress P = ∂Ψ/∂F [Pa], tangent A = ∂P/∂F [Pa] and its
/// action on a change of H. All of them see the D components in the model; what happens in the 3 −
/// D missing directions is the law's own affair and comes out as `transverse_stretch` and
/// `transverse_stress`.
///
/// Page of the room:
///   law.hpp                                          what a law is
///   linear_elastic, st_venant_kirchhoff, neo_hookean the laws
///   given_law.hpp                                    a law of the caller's own
///   any_law.hpp                                      the list of them, and the maker
///   lame.hpp, waves.hpp                              elastic constants, wave speeds, hyperbolicity
///   stress.hpp                                       Cauchy stress, pressure, von Mises
///   uniaxial.hpp                                     the inverse P⁻¹(t̄)
///
/// `margin` says where a law ends: at det F ≤ 0, where Neo-Hookean functions return NaN, and for St
/// Venant–Kirchhoff free of transverse stress at 1 + 2E_33 ≤ 0, though its stress is a polynomial,
/// finite for any H. None of the functions throws or branches on it: test the state outside the
/// inner loop.

#include <concepts>
#include <string_view>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// The kinematic assumption behind the missing dimensions: no strain there (1D strain, plane
/// strain) or no stress there (1D stress, plane stress).
enum class Assumption { strain, stress };

/// A_(ia)(jb) = ∂P_ia/∂F_jb, rows and columns numbered i*D + a.
template <int D>
using Tangent = Eigen::Matrix<double, D * D, D * D>;

template <class L, int D>
concept ElasticLaw = requires(const L& law, const Tensor<D>& H) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::small_strain } -> std::convertible_to<bool>;  // linear in H: P and Cauchy stress coincide
  { law.energy(H) } -> std::same_as<double>;
  { law.pk1(H) } -> std::same_as<Tensor<D>>;
  { law.dpk1(H, H) } -> std::same_as<Tensor<D>>;  // A : dH at H, second argument dH
  { law.tangent(H) } -> std::same_as<Tangent<D>>;
  { law.transverse_stretch(H) } -> std::same_as<double>;  // F_33, and F_22 in 1D
  { law.transverse_stress(H) } -> std::same_as<double>;   // Cauchy stress there [Pa]
  { law.margin(H) } -> std::same_as<double>;              // positive inside the law's range
};

/// The tangent assembled from its action, column (j, b) being the answer to a unit change of F_jb.
template <int D, class Law>
[[nodiscard]] Tangent<D> tangent_from_action(const Law& law, const Tensor<D>& H) {
  Tangent<D> A;
  for (int j = 0; j < D; ++j)
    for (int b = 0; b < D; ++b) {
      Tensor<D> unit = Tensor<D>::Zero();
      unit(j, b) = 1.0;
      const Tensor<D> column = law.dpk1(H, unit);
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) A(i * D + a, j * D + b) = column(i, a);
    }
  return A;
}

}  // namespace tlsph

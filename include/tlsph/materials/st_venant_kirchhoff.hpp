#pragma once
/// \file
/// St Venant–Kirchhoff: P = F S with S = λ tr(E) I + 2μ E, E the Green–Lagrange strain. Where the
/// missing directions are free of stress, S_33 = 0 is linear in E_33 and leaves the same law with
/// the reduced λ.

#include <cmath>

#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/lame.hpp"

namespace tlsph {

template <int D, Assumption A = Assumption::strain>
class StVenantKirchhoff {
 public:
  static constexpr std::string_view name = "st-venant-kirchhoff";
  static constexpr bool small_strain = false;

  explicit StVenantKirchhoff(const Lame& constants)
      : lambda_(reduced_lambda(constants, D, A)),
        mu_(constants.mu),
        transverse_ratio_(constants.lambda / (2 * constants.mu + (3 - D) * constants.lambda)) {}

  /// Ψ = λ/2 (tr E)² + μ E:E.
  [[nodiscard]] double energy(const Tensor<D>& H) const {
    const Tensor<D> E = green_lagrange<D>(H);
    const double trace = E.trace();
    return 0.5 * lambda_ * trace * trace + mu_ * E.squaredNorm();
  }

  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H) const {
    const Tensor<D> S = stress(green_lagrange<D>(H));
    return S + H * S;
  }

  /// dP = dH S + F dS, dS from dE = sym(Fᵀ dH). Component by component: fixed-size matrix
  /// expressions go through memory here and take twice as long.
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    double E[D][D], dE[D][D];
    double trace = 0.0, change = 0.0;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) {
        double sum = H(a, b) + H(b, a);
        double dsum = dH(a, b) + dH(b, a);
        for (int i = 0; i < D; ++i) {
          sum += H(i, a) * H(i, b);
          dsum += H(i, a) * dH(i, b) + dH(i, a) * H(i, b);
        }
        E[a][b] = E[b][a] = 0.5 * sum;
        dE[a][b] = dE[b][a] = 0.5 * dsum;
        if (a == b) {
          trace += E[a][a];
          change += dE[a][a];
        }
      }
    Tensor<D> dP;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        double sum = lambda_ * (trace * dH(i, a) + change * ((i == a ? 1.0 : 0.0) + H(i, a))) +
                     2 * mu_ * dE[i][a];
        for (int b = 0; b < D; ++b) sum += 2 * mu_ * (dH(i, b) * E[b][a] + H(i, b) * dE[b][a]);
        dP(i, a) = sum;
      }
    return dP;
  }

  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const {
    return tangent_from_action<D>(*this, H);
  }

  /// 1, or √(1 + 2E_33) where the stress is zero; NaN once 1 + 2E_33 < 0, when no real stretch
  /// frees the body of transverse stress any more.
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    if constexpr (A == Assumption::strain) return 1.0;
    return std::sqrt(transverse_square(H));
  }

  /// det F, or 1 + 2E_33 where the stress is zero and that is smaller.
  [[nodiscard]] double margin(const Tensor<D>& H) const {
    const double J = 1 + volume_change<D>(H);
    if constexpr (A == Assumption::strain || D == 3) return J;
    const double square = transverse_square(H);
    return J < square ? J : square;
  }

  /// The stretch √(1 + 1/ν) at which uniaxial tension makes 1 + 2E_33 zero.
  [[nodiscard]] double largest_uniaxial_stretch() const requires(A == Assumption::stress) {
    const double poisson = D == 1 ? transverse_ratio_ : transverse_ratio_ / (1 + transverse_ratio_);
    return std::sqrt(1 + 1 / poisson);
  }

  /// Cauchy σ_33 = F_33 S_33 F_33/J = λ tr(E)/J, or zero.
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    if constexpr (A == Assumption::stress) return 0.0;
    return lambda_ * green_lagrange<D>(H).trace() / (1 + volume_change<D>(H));
  }

  /// λ [Pa], reduced where the missing directions are free of stress.
  [[nodiscard]] double lambda() const { return lambda_; }
  /// μ [Pa].
  [[nodiscard]] double mu() const { return mu_; }

 private:
  /// 1 + 2E_33 where the stress is zero.
  [[nodiscard]] double transverse_square(const Tensor<D>& H) const {
    return 1 - 2 * transverse_ratio_ * green_lagrange<D>(H).trace();
  }
  [[nodiscard]] Tensor<D> stress(const Tensor<D>& E) const {
    return lambda_ * E.trace() * Tensor<D>::Identity() + 2 * mu_ * E;
  }

  double lambda_;
  double mu_;
  double transverse_ratio_;
};

static_assert(ElasticLaw<StVenantKirchhoff<1, Assumption::stress>, 1>);
static_assert(ElasticLaw<StVenantKirchhoff<2>, 2> && ElasticLaw<StVenantKirchhoff<3>, 3>);

}  // namespace tlsph

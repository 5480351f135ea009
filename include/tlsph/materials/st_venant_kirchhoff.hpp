#pragma once
/// \file
/// St Venant–Kirchhoff: P = F S with S = λ tr(E) I + 2μ E, E the Green–Lagrange strain. Where the
/// missing directions are free of stress, S_33 = 0 is linear in E_33 and leaves the same law with
/// the reduced λ; 1 + 2E_33 = 1 − λ tr(E)/μ with that λ.

#include <span>

#include "tlsph/materials/law_constant.hpp"
#include "tlsph/materials/linear_elastic.hpp"

namespace tlsph::laws {

template <int D, Assumption A>
class StVenantKirchhoff {
 public:
  static constexpr int dimension = D;
  static constexpr std::string_view name = "st-venant-kirchhoff";
  static constexpr auto keys = isotropic_constants;
  static constexpr bool small_strain = false;
  static constexpr double multiply_adds = D == 1 ? 4.0 : 24.0;
  static constexpr std::string_view range =
      A == Assumption::strain
          ? "det F > 0"
          : "det F > 0 and 1 + 2 E_33 > 0, E_33 the strain of the directions free of stress";

  explicit StVenantKirchhoff(std::span<const double> values)
      : StVenantKirchhoff(lame(values[0], values[1])) {}
  explicit StVenantKirchhoff(const Lame& constants)
      : constants_(constants), lambda_(reduced_lambda(constants, D, A)), mu_(constants.mu) {}

  /// Ψ = λ/2 (tr E)² + μ E:E.
  template <class R>
  [[nodiscard]] R energy(const TensorOf<D, R>& H) const {
    const TensorOf<D, R> E = green_lagrange<D>(H);
    const R volume = trace<D>(E);
    R sum = 0.5 * lambda_ * volume * volume;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) sum = sum + mu_ * E(a, b) * E(a, b);
    return sum;
  }

  template <class R>
  [[nodiscard]] [[gnu::always_inline]] TensorOf<D, R> stress(const TensorOf<D, R>& H,
                                                             Mask<R>& good) const {
    const R e = volume_change<D>(H);
    good &= (e > -1.0) & (e < huge);
    R pressure;
    const TensorOf<D, R> S = second_stress(H, pressure);
    if constexpr (free) good &= pressure < mu_;
    TensorOf<D, R> P;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        R sum = H(i, 0) * S(0, a);
        for (int b = 1; b < D; ++b) sum = sum + H(i, b) * S(b, a);
        P(i, a) = S(i, a) + sum;
      }
    return P;
  }

  /// δ_ij S_ab + λ F_ia F_jb + μ (δ_ab (F Fᵀ)_ij + F_ib F_ja).
  template <class R>
  [[nodiscard]] [[gnu::always_inline]] TensorOf<D * D, R> tangent(const TensorOf<D, R>& H) const {
    R pressure;
    const TensorOf<D, R> S = second_stress(H, pressure);
    const TensorOf<D, R> F = deformation_gradient<D>(H);
    TensorOf<D * D, R> result;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        R product = F(i, 0) * F(j, 0);
        for (int a = 1; a < D; ++a) product = product + F(i, a) * F(j, a);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b) {
            R sum = lambda_ * F(i, a) * F(j, b) + mu_ * F(i, b) * F(j, a);
            if (i == j) sum = sum + S(a, b);
            if (a == b) sum = sum + mu_ * product;
            result(i * D + a, j * D + b) = sum;
          }
      }
    return result;
  }

  /// 1, or √(1 + 2E_33) where the stress is zero; NaN once 1 + 2E_33 < 0, when no real stretch
  /// frees the body of transverse stress any more.
  [[nodiscard]] double transverse_stretch(const TensorOf<D, double>& H) const {
    return free ? std::sqrt(transverse_square(H)) : 1.0;
  }

  /// det F, or 1 + 2E_33 where the stress is zero and that is smaller.
  [[nodiscard]] double margin(const TensorOf<D, double>& H) const {
    const double J = 1 + volume_change<D>(H);
    if (!free) return J;
    const double square = transverse_square(H);
    return J < square ? J : square;
  }

  /// The stretch √(1 + 1/ν) at which uniaxial tension makes 1 + 2E_33 zero.
  [[nodiscard]] double largest_uniaxial_stretch() const requires(A == Assumption::stress) {
    const double poisson = constants_.lambda / (2 * (constants_.lambda + constants_.mu));
    return std::sqrt(1 + 1 / poisson);
  }

  /// Cauchy σ_33 = F_33 S_33 F_33/J = λ tr(E)/J, or zero.
  [[nodiscard]] double transverse_stress(const TensorOf<D, double>& H) const {
    if (A == Assumption::stress) return 0.0;
    return lambda_ * trace<D>(green_lagrange<D>(H)) / (1 + volume_change<D>(H));
  }

  /// The law of small strains.
  [[nodiscard]] LinearElastic<D, A> at_rest() const { return LinearElastic<D, A>(constants_); }

 private:
  static constexpr bool free = A == Assumption::stress && D < 3;

  /// S, and λ tr E.
  template <class R>
  [[gnu::always_inline]] TensorOf<D, R> second_stress(const TensorOf<D, R>& H, R& pressure) const {
    const TensorOf<D, R> E = green_lagrange<D>(H);
    pressure = lambda_ * trace<D>(E);
    TensorOf<D, R> S;
    for (int a = 0; a < D; ++a) {
      for (int b = a; b < D; ++b) S(a, b) = S(b, a) = 2.0 * mu_ * E(a, b);
      S(a, a) = pressure + S(a, a);
    }
    return S;
  }

  [[nodiscard]] double transverse_square(const TensorOf<D, double>& H) const {
    return 1 - lambda_ * trace<D>(green_lagrange<D>(H)) / mu_;
  }

  Lame constants_;
  double lambda_;
  double mu_;
};

}  // namespace tlsph::laws

#pragma once
/// \file
/// Linear elasticity: P = λ tr(ε) I + 2μ ε with ε = (H + Hᵀ)/2. The reference and the deformed
/// configuration are not told apart, so P is also the Cauchy stress.

#include <span>
#include <string_view>

#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/lame.hpp"
#include "tlsph/materials/law_constant.hpp"

namespace tlsph::laws {

template <int D, Assumption A>
class LinearElastic {
 public:
  static constexpr int dimension = D;
  static constexpr std::string_view name = "linear-elastic";
  static constexpr auto keys = isotropic_constants;
  static constexpr bool small_strain = true;
  static constexpr double multiply_adds = D == 1 ? 1.0 : 6.0;

  explicit LinearElastic(std::span<const double> values)
      : LinearElastic(lame(values[0], values[1])) {}
  explicit LinearElastic(const Lame& constants)
      : lambda_(reduced_lambda(constants, D, A)),
        mu_(constants.mu),
        transverse_ratio_(constants.lambda / (2 * constants.mu + (3 - D) * constants.lambda)) {}

  /// Ψ = λ/2 (tr ε)² + μ ε:ε.
  template <class R>
  [[nodiscard]] R energy(const TensorOf<D, R>& H) const {
    const R volume = trace<D>(H);
    R sum = 0.5 * lambda_ * volume * volume;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        const R strain = 0.5 * (H(i, a) + H(a, i));
        sum = sum + mu_ * strain * strain;
      }
    return sum;
  }

  template <class R>
  [[nodiscard]] [[gnu::always_inline]] TensorOf<D, R> stress(const TensorOf<D, R>& H,
                                                             Mask<R>& good) const {
    const R volume = trace<D>(H);
    TensorOf<D, R> P;
    auto size = Numbers<R>::magnitude(volume);
    for (int i = 0; i < D; ++i) {
      P(i, i) = lambda_ * volume + 2.0 * mu_ * H(i, i);
      size = size + Numbers<R>::magnitude(P(i, i));
      for (int a = i + 1; a < D; ++a) {
        P(i, a) = P(a, i) = mu_ * (H(i, a) + H(a, i));
        size = size + Numbers<R>::magnitude(P(i, a));
      }
    }
    good &= size < huge;
    return P;
  }

  /// 1, or 1 − λ tr(ε)/(2μ + (3−D)λ) where the stress is zero.
  [[nodiscard]] double transverse_stretch(const TensorOf<D, double>& H) const {
    return A == Assumption::strain ? 1.0 : 1.0 - transverse_ratio_ * trace<D>(H);
  }

  /// λ tr ε, or zero.
  [[nodiscard]] double transverse_stress(const TensorOf<D, double>& H) const {
    return A == Assumption::strain ? lambda_ * trace<D>(H) : 0.0;
  }

  /// Always positive: small strains know no det F.
  [[nodiscard]] double margin(const TensorOf<D, double>&) const { return 1.0; }

  [[nodiscard]] const LinearElastic& at_rest() const { return *this; }
  /// λ [Pa], reduced where the missing directions are free of stress.
  [[nodiscard]] double lambda() const { return lambda_; }
  /// μ [Pa].
  [[nodiscard]] double mu() const { return mu_; }

 private:
  double lambda_;
  double mu_;
  double transverse_ratio_;
};

}  // namespace tlsph::laws

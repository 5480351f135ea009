#pragma once
/// \file
/// Linear elasticity: P = λ tr(ε) I + 2μ ε with ε = (H + Hᵀ)/2. The reference and the deformed
/// configuration are not told apart, so P is also the Cauchy stress.

#include "tlsph/materials/lame.hpp"

namespace tlsph {

template <int D, Assumption A = Assumption::strain>
class LinearElastic {
 public:
  static constexpr std::string_view name = "linear-elastic";
  static constexpr bool small_strain = true;

  explicit LinearElastic(const Lame& constants)
      : lambda_(reduced_lambda(constants, D, A)),
        mu_(constants.mu),
        transverse_ratio_(constants.lambda / (2 * constants.mu + (3 - D) * constants.lambda)) {}

  /// Ψ = λ/2 (tr ε)² + μ ε:ε.
  [[nodiscard]] double energy(const Tensor<D>& H) const {
    const double trace = H.trace();
    return 0.5 * lambda_ * trace * trace + mu_ * symmetric(H).squaredNorm();
  }

  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H) const {
    Tensor<D> P = mu_ * (H + H.transpose());
    P.diagonal().array() += lambda_ * H.trace();
    return P;
  }

  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>&, const Tensor<D>& dH) const { return pk1(dH); }

  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const {
    return tangent_from_action<D>(*this, H);
  }

  /// 1, or 1 − λ tr(ε)/(2μ + (3−D)λ) where the stress is zero.
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    return A == Assumption::strain ? 1.0 : 1.0 - transverse_ratio_ * H.trace();
  }

  /// λ tr ε, or zero.
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    return A == Assumption::strain ? lambda_ * H.trace() : 0.0;
  }

  /// Always positive: small strains know no det F.
  [[nodiscard]] double margin(const Tensor<D>&) const { return 1.0; }

  /// λ [Pa], reduced where the missing directions are free of stress.
  [[nodiscard]] double lambda() const { return lambda_; }
  /// μ [Pa].
  [[nodiscard]] double mu() const { return mu_; }

 private:
  static Tensor<D> symmetric(const Tensor<D>& H) { return 0.5 * (H + H.transpose()); }

  double lambda_;
  double mu_;
  double transverse_ratio_;
};

static_assert(ElasticLaw<LinearElastic<1, Assumption::stress>, 1>);
static_assert(ElasticLaw<LinearElastic<2>, 2> && ElasticLaw<LinearElastic<3>, 3>);

}  // namespace tlsph

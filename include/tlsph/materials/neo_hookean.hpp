#pragma once
/// \file
/// Compressible Neo-Hookean, (3.62)–(3.64) of the thesis:
///
///     Ψ = μ/2 (tr C − 3) − μ ln J + λ/2 (ln J)²
///     P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ
///
/// with the three-dimensional C and J. Where the missing directions are free of stress, their
/// common stretch s solves P_33 = 0, that is μ(s² − 1) + λ ln J = 0, pointwise. Every function
/// returns NaN for det F ≤ 0.

#include <cmath>
#include <limits>

#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/lame.hpp"

namespace tlsph {

template <int D, Assumption A = Assumption::strain>
class NeoHookean {
 public:
  static constexpr std::string_view name = "neo-hookean";
  static constexpr bool small_strain = false;

  explicit NeoHookean(const Lame& constants) : lambda_(constants.lambda), mu_(constants.mu) {}

  /// With e = J − 1, (tr C − D)/2 − ln J = H:H/2 − (e − tr H) − (ln J − e), each bracket of second
  /// order, so a strain of 1e-7 keeps its energy to round-off.
  [[nodiscard]] double energy(const Tensor<D>& H) const {
    const double e = volume_change<D>(H);
    const Volume volume = volume_at(log_volume(e));
    const double shear = distortion(H) - log1p_minus(e);
    // (s² − 1)/2 − ln s for each free direction, from x = s² − 1
    const double transverse = -0.5 * log1p_minus(volume.transverse_square_change);
    return mu_ * (shear + free_directions * transverse) + 0.5 * volume.pressure * volume.log;
  }

  /// μ (F − F⁻ᵀ) = μ (e F + F − cof F)/J; one logarithm and one division in strain. Component by
  /// component, because this is the innermost loop: fixed-size matrix expressions go through memory
  /// here and take twice as long.
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H) const {
    const double e = volume_change<D>(H);
    const double inverse = 1 / (1 + e);
    const double pressure = volume_at(log_volume(e)).pressure;
    const Tensor<D> symmetric = deformation_minus_cofactor<D>(H);
    Tensor<D> P;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        const double F = H(i, a) + (i == a ? 1.0 : 0.0);
        const double cof = F - symmetric(i, a);
        P(i, a) = (mu_ * (e * F + symmetric(i, a)) + pressure * cof) * inverse;
      }
    return P;
  }

  /// dP = μ dH + (μ − p) F⁻ᵀ dHᵀ F⁻ᵀ + p' (F⁻ᵀ : dH) F⁻ᵀ, p = λ ln J and p' its derivative to ln J
  /// in the model's directions, the free ones condensed out.
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    if constexpr (D == 2) return dpk1(plane_tangent(H), H, dH);
    const double e = volume_change<D>(H);
    const Volume volume = volume_at(log_volume(e));
    const Tensor<D> inverse = cofactor<D>(deformation_gradient<D>(H)) * (1 / (1 + e));  // F⁻ᵀ
    return mu_ * dH + (mu_ - volume.pressure) * (inverse * dH.transpose() * inverse) +
           volume.stiffness * inverse.cwiseProduct(dH).sum() * inverse;
  }

  /// What of `dpk1` in the plane takes a logarithm and a division: (μ − p)/J and (μ − p + p')/J².
  struct PlaneTangent {
    double turned, along;
  };
  [[nodiscard]] PlaneTangent plane_tangent(const Tensor<D>& H) const requires(D == 2) {
    const double e = volume_change<D>(H);
    const double inverse = 1 / (1 + e);
    const Volume volume = volume_at(log_volume(e));
    const double excess = mu_ - volume.pressure;
    return {excess * inverse, (excess + volume.stiffness) * inverse * inverse};
  }

  /// In the plane the cofactor is linear, so that with c = cof F = J F⁻ᵀ
  /// dP = μ dH − (μ − p)/J cof dH + (μ − p + p')/J² (c : dH) c. Component by component, as `pk1`.
  [[nodiscard]] Tensor<D> dpk1(const PlaneTangent& at, const Tensor<D>& H,
                               const Tensor<D>& dH) const requires(D == 2) {
    const double c[4] = {1 + H(1, 1), -H(1, 0), -H(0, 1), 1 + H(0, 0)};
    const double along =
        at.along * (c[0] * dH(0, 0) + c[1] * dH(0, 1) + c[2] * dH(1, 0) + c[3] * dH(1, 1));
    Tensor<D> dP;
    dP(0, 0) = mu_ * dH(0, 0) - at.turned * dH(1, 1) + along * c[0];
    dP(0, 1) = mu_ * dH(0, 1) + at.turned * dH(1, 0) + along * c[1];
    dP(1, 0) = mu_ * dH(1, 0) + at.turned * dH(0, 1) + along * c[2];
    dP(1, 1) = mu_ * dH(1, 1) - at.turned * dH(0, 0) + along * c[3];
    return dP;
  }

  /// The matrix of `dpk1`, for the price of one of its columns.
  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const {
    const double e = volume_change<D>(H);
    const Volume volume = volume_at(log_volume(e));
    const Tensor<D> inverse = cofactor<D>(deformation_gradient<D>(H)) * (1 / (1 + e));  // F⁻ᵀ
    Tangent<D> result;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        for (int j = 0; j < D; ++j)
          for (int b = 0; b < D; ++b)
            result(i * D + a, j * D + b) = (i == j && a == b ? mu_ : 0.0) +
                                           (mu_ - volume.pressure) * inverse(i, b) * inverse(j, a) +
                                           volume.stiffness * inverse(i, a) * inverse(j, b);
    return result;
  }

  /// 1, or the stretch s that frees the missing directions of stress.
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    return std::exp(volume_at(log_volume(volume_change<D>(H))).transverse_log);
  }

  /// Cauchy σ_33 = λ ln J / J (with F_33 = 1), or zero.
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    if constexpr (A == Assumption::stress) return 0.0;
    const double e = volume_change<D>(H);
    return lambda_ * log_volume(e) / (1 + e);
  }

  /// det F; NaN where it is positive and the missing directions cannot be freed of stress, which
  /// happens for λ < 0 only.
  [[nodiscard]] double margin(const Tensor<D>& H) const {
    const double J = 1 + volume_change<D>(H);
    if (free_directions == 0 || lambda_ >= 0 || !(J > 0)) return J;
    return J + 0 * transverse_stretch(H);
  }

  /// λ of the three-dimensional law [Pa].
  [[nodiscard]] double lambda() const { return lambda_; }
  /// μ [Pa].
  [[nodiscard]] double mu() const { return mu_; }

 private:
  static constexpr int free_directions = A == Assumption::stress ? 3 - D : 0;

  /// What the volume does, given ln J of the model's directions.
  struct Volume {
    double log;                       ///< ln J of the three-dimensional body
    double pressure;                  ///< p = λ ln J [Pa]
    double stiffness;                 ///< dp/d(ln J of the model's directions) [Pa]
    double transverse_log;            ///< ln s
    double transverse_square_change;  ///< s² − 1
  };

  [[nodiscard]] Volume volume_at(double log_model) const {
    if constexpr (free_directions == 0)
      return {log_model, lambda_ * log_model, lambda_, 0.0, 0.0};
    else
      return free_volume(log_model);
  }

  /// Solves f(y) = μ(e²ʸ − 1) + λ(ln J_model + n y) = 0 for y = ln s by Newton. f is convex and
  /// grows at y = 0, so the step from there lands on or right of the root of that branch and the
  /// rest fall to it monotonically. For λ < 0 the branch ends where f stops growing: without a root
  /// on it, NaN.
  [[nodiscard]] Volume free_volume(double log_model) const {
    constexpr int n = free_directions;
    double y = -lambda_ * log_model / (2 * mu_ + n * lambda_);
    for (int iteration = 0; iteration < 60; ++iteration) {
      const double change = std::expm1(2 * y);
      const double slope = 2 * mu_ * (1 + change) + n * lambda_;
      const double step = (mu_ * change + lambda_ * (log_model + n * y)) / slope;
      if (!(slope > 0)) break;
      y -= step;
      // one more step would be below round-off
      if (std::abs(step) <= 1e-10 * std::abs(y)) return free_volume(log_model, y);
    }
    return free_volume(log_model, std::numeric_limits<double>::quiet_NaN());
  }

  [[nodiscard]] Volume free_volume(double log_model, double y) const {
    constexpr int n = free_directions;
    const double change = std::expm1(2 * y);
    const double shear = 2 * mu_ * (1 + change);
    // p = −μ(s² − 1) is the same as λ ln J without its cancellation at large λ
    return {log_model + n * y, -mu_ * change, lambda_ * shear / (shear + n * lambda_), y, change};
  }

  /// H:H/2 − (J − 1 − tr H).
  [[nodiscard]] static double distortion(const Tensor<D>& H) {
    if constexpr (D == 2) {
      const double stretch = H(0, 0) - H(1, 1);
      const double shear = H(0, 1) + H(1, 0);
      return 0.5 * (stretch * stretch + shear * shear);
    } else {
      return 0.5 * H.squaredNorm() - nonlinear_volume_change<D>(H);
    }
  }

  double lambda_;
  double mu_;
};

static_assert(ElasticLaw<NeoHookean<1, Assumption::stress>, 1>);
static_assert(ElasticLaw<NeoHookean<2>, 2> && ElasticLaw<NeoHookean<3>, 3>);

}  // namespace tlsph

#pragma once
/// \file
/// Compressible Neo-Hookean, (3.62)–(3.64) of the thesis:
///
///     Ψ = μ/2 (tr C − 3) − μ ln J + λ/2 (ln J)²
///     P = μ (F − F⁻ᵀ) + p F⁻ᵀ,  p = λ ln J
///
/// with the three-dimensional C and J. Where n missing directions are free of stress, their common
/// stretch s solves P_33 = 0, that is μ(s² − 1) + λ ln J = 0, pointwise: p = −μ(s² − 1), which is
/// λ ln J without its cancellation at large λ. Every function returns NaN for det F ≤ 0.

#include <limits>
#include <span>

#include "tlsph/materials/dual.hpp"
#include "tlsph/materials/law_constant.hpp"
#include "tlsph/materials/linear_elastic.hpp"

namespace tlsph::laws {

template <int D, Assumption A>
class NeoHookean {
 public:
  static constexpr int dimension = D;
  static constexpr std::string_view name = "neo-hookean";
  static constexpr auto keys = isotropic_constants;
  static constexpr bool small_strain = false;
  /// The logarithm of a small change 10; two steps to the transverse stretch at small strains.
  static constexpr double multiply_adds =
      (D == 1 ? 18.0 : 31.0) + (A == Assumption::stress ? 2 * 20.0 : 0.0);
  static constexpr std::string_view range =
      A == Assumption::strain
          ? "det F > 0"
          : "det F > 0 and, for a negative Poisson's ratio, a transverse stretch "
            "free of stress";

  explicit NeoHookean(std::span<const double> values) : NeoHookean(lame(values[0], values[1])) {}
  explicit NeoHookean(const Lame& constants) : lambda_(constants.lambda), mu_(constants.mu) {}

  /// With e = J − 1, (tr C − D)/2 − ln J = H:H/2 − (e − tr H) − (ln J − e), each bracket of second
  /// order, so a strain of 1e-7 keeps its energy to round-off; likewise (s² − 1)/2 − ln s for each
  /// free direction, from c = s² − 1.
  template <class R>
  [[nodiscard]] R energy(const TensorOf<D, R>& H) const {
    Mask<R> good{};
    R inverse;
    const R e = volume_change<D>(H);
    R log = Numbers<R>::log_and_inverse(e, inverse, good);
    R shear = distortion(H) - Numbers<R>::log_minus(e);
    if constexpr (n == 0) return mu_ * shear + 0.5 * lambda_ * log * log;
    const R c = square_change<true>(log, good);
    if (c < small_square) {
      shear = shear - (transverse_log(c, log) - 0.5 * n * c);
      log = -mu_ / lambda_ * c;
    } else {
      shear = shear - 0.5 * n * Numbers<R>::log_minus(c);
      log = log + 0.5 * n * Numbers<R>::log_and_inverse(c, inverse, good);
    }
    return mu_ * shear - 0.5 * mu_ * c * log;
  }

  /// μ (F − F⁻ᵀ) = μ (e F + F − cof F)/J; one logarithm and one division in strain.
  template <class R>
  [[nodiscard]] [[gnu::always_inline]] TensorOf<D, R> stress(const TensorOf<D, R>& H,
                                                             Mask<R>& good) const {
    const R e = volume_change<D>(H);
    R inverse;
    const R log = Numbers<R>::log_and_inverse(e, inverse, good);
    const R normal = pressure(log, good) * inverse;
    const R shear = mu_ * inverse;
    const R dilation = shear * e;
    const TensorOf<D, R> F = deformation_gradient<D>(H);
    const TensorOf<D, R> cof = cofactor<D>(F);
    const TensorOf<D, R> difference = deformation_minus_cofactor<D>(H);
    TensorOf<D, R> P;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        P(i, a) = dilation * F(i, a) + shear * difference(i, a) + normal * cof(i, a);
    return P;
  }

  /// μ δ_ij δ_ab + (μ − p) F⁻ᵀ_ib F⁻ᵀ_ja + p' F⁻ᵀ_ia F⁻ᵀ_jb with p' = dp/d(ln J) in the model's
  /// directions, the free ones condensed out.
  template <class R>
  [[nodiscard]] [[gnu::always_inline]] TensorOf<D * D, R> tangent(const TensorOf<D, R>& H) const {
    Mask<R> good{};
    R inverse, rate = Numbers<R>::all(lambda_);
    const R log = Numbers<R>::log_and_inverse(volume_change<D>(H), inverse, good);
    R excess = mu_ - lambda_ * log;
    if constexpr (n > 0) {
      const R c = square_change(log, good);
      excess = mu_ + mu_ * c;
      rate = -mu_ * slope_of_change(c);
    }
    const R square = inverse * inverse;
    const R turned = excess * square, along = rate * square;
    const TensorOf<D, R> cof = cofactor<D>(deformation_gradient<D>(H));
    TensorOf<D * D, R> result;
    for (int row = 0; row < D * D; ++row)
      for (int column = 0; column < D * D; ++column) {
        const int i = row / D, a = row % D, j = column / D, b = column % D;
        const R sum = turned * cof(i, b) * cof(j, a) + along * cof(i, a) * cof(j, b);
        result(row, column) = row == column ? mu_ + sum : sum;
      }
    return result;
  }

  /// 1, or the stretch s that frees the missing directions of stress.
  [[nodiscard]] double transverse_stretch(const TensorOf<D, double>& H) const {
    if constexpr (n == 0) return 1.0;
    bool good = true;
    const double log = log_volume(volume_change<D>(H));
    const double c = square_change<true>(log, good);
    return c < small_square ? std::exp(transverse_log(c, log) / n) : std::sqrt(1 + c);
  }

  /// Cauchy σ_33 = λ ln J / J (with F_33 = 1), or zero.
  [[nodiscard]] double transverse_stress(const TensorOf<D, double>& H) const {
    if (A == Assumption::stress) return 0.0;
    const double e = volume_change<D>(H);
    return lambda_ * log_volume(e) / (1 + e);
  }

  /// det F; NaN where it is positive and the missing directions cannot be freed of stress, which
  /// happens for λ < 0 only.
  [[nodiscard]] double margin(const TensorOf<D, double>& H) const {
    const double J = 1 + volume_change<D>(H);
    if (n == 0 || lambda_ >= 0 || !(J > 0)) return J;
    return J + 0 * transverse_stretch(H);
  }

  /// The law of small strains.
  [[nodiscard]] LinearElastic<D, A> at_rest() const { return LinearElastic<D, A>({lambda_, mu_}); }

 private:
  static constexpr int n = A == Assumption::stress ? 3 - D : 0;

  /// H:H/2 − (J − 1 − tr H).
  template <class R>
  [[nodiscard]] static R distortion(const TensorOf<D, R>& H) {
    if constexpr (D == 2) {
      const R stretch = H(0, 0) - H(1, 1);
      const R shear = H(0, 1) + H(1, 0);
      return 0.5 * (stretch * stretch + shear * shear);
    } else {
      R sum = 0.5 * H(0, 0) * H(0, 0);
      for (int k = 1; k < D * D; ++k) sum = sum + 0.5 * H(k / D, k % D) * H(k / D, k % D);
      return sum - nonlinear_volume_change<D>(H);
    }
  }

  /// Where c is less, 1 + c has lost digits of s², and n ln s comes from λ ln J = p.
  static constexpr double small_square = -0.5;
  template <class R>
  [[nodiscard]] R transverse_log(const R& c, const R& log) const {
    return -mu_ / lambda_ * c - log;
  }

  /// p from ln J of the model's directions.
  template <class R>
  [[nodiscard]] [[gnu::always_inline]] R pressure(const R& log, Mask<R>& good) const {
    if constexpr (n == 0)
      return lambda_ * log;
    else
      return -mu_ * square_change(log, good);
  }

  /// c = s² − 1 of the free directions by Newton,
  ///
  ///     g(c) = μ c + λ (ln J + n/2 ln(1 + c)) = 0,
  ///
  /// which grows at c = 0. For λ ≥ 0 it is concave: from the second iterate on the way goes up to
  /// the root. For λ < 0 it is convex and the way goes down to the root of the branch that grows;
  /// without a root on it NaN. Right to round-off relative to c and, with `OfSquare`, to s² = 1 +
  /// c down to 1e-5; in stress and tangent s² is added to 1, and the first is enough.
  template <bool OfSquare = false, class R>
  [[nodiscard]] [[gnu::always_inline]] R square_change(const R& log, Mask<R>& good) const {
    constexpr int most_iterations = 60;
    R c = at_least<R>(-lambda_ / (mu_ + 0.5 * n * lambda_) * log, Numbers<R>::all(-0.9));
    Mask<R> found{};
    for (int k = 0; k < most_iterations && !Numbers<R>::everywhere(found); ++k) {
      R inverse;
      const R transverse = Numbers<R>::log_and_inverse(c, inverse, good);
      const R slope = mu_ + 0.5 * n * lambda_ * inverse;
      const R step = (mu_ * c + lambda_ * (log + 0.5 * n * transverse)) / slope;
      // the next step would be below round-off
      found = Numbers<R>::magnitude(step) <= 1e-9 * Numbers<R>::magnitude(c);
      if constexpr (OfSquare) found &= Numbers<R>::magnitude(step) <= 1e-9 * (c + 1.0) + 1e-14;
      if (lambda_ < 0.0) found &= slope > 0.0;
      c = at_least<R>(c - step, 0.1 * (1.0 + c) - 1.0);
    }
    good &= found;
    return found ? c : Numbers<R>::all(std::numeric_limits<double>::quiet_NaN());
  }

  /// dc/d(ln J) = −λ/g'.
  template <class R>
  [[nodiscard]] [[gnu::always_inline]] R slope_of_change(const R& c) const {
    return -lambda_ * (1.0 + c) / (mu_ + 0.5 * n * lambda_ + mu_ * c);
  }
  template <bool OfSquare = false, class R, int N>
  [[nodiscard]] [[gnu::always_inline]] Dual<R, N> square_change(const Dual<R, N>& log,
                                                                Mask<R>& good) const {
    const R c = square_change<OfSquare>(log.value, good);
    const R slope = slope_of_change(c);
    return dual<N>(c, [&](int k) { return slope * log.change[k]; });
  }

  template <class R>
  [[nodiscard]] [[gnu::always_inline]] static R at_least(const R& value, const R& bound) {
    return value > bound ? value : bound;
  }

  double lambda_;
  double mu_;
};

}  // namespace tlsph::laws

#pragma once
/// \file
/// What the arithmetic of a law is written in. A law is a template of the number type R: `double`,
/// a vector of doubles (the inner loops of a sweep bring theirs) or a dual number of either
/// (dual.hpp). `Numbers<R>` is what such a type can do beside +, −, ×, / and comparisons with a
/// double, as dual.hpp has them.
///
/// No Eigen and no fmt here nor in the laws: the inner loops are compiled once an instruction set,
/// and an inline function that both they and the rest of the program instantiate would be linked
/// once only.

#include <cmath>
#include <type_traits>
#include <utility>

namespace tlsph {

template <class R>
struct Numbers;

/// The answer of a comparison of R.
template <class R>
using Mask = typename Numbers<R>::Mask;

/// The D×D components of a tensor, `(i, a)` as in core/types.hpp.
template <int D, class R>
struct TensorOf {
  R component[D][D];

  [[gnu::always_inline]] R& operator()(int i, int a) { return component[i][a]; }
  [[gnu::always_inline]] const R& operator()(int i, int a) const { return component[i][a]; }
};

/// The number type of a tensor: a TensorOf, or one of Eigen's.
template <class M>
using NumberOf = std::remove_cvref_t<decltype(std::declval<const M&>()(0, 0))>;

/// Larger stresses and strains count as not finite.
inline constexpr double huge = 0x1p1000;

/// ln J from e = J − 1 to full relative precision, NaN for J ≤ 0. The rounding error of 1 + e is
/// known exactly and put back; cheaper than log1p, and the division by J is one the caller needs
/// anyway.
[[nodiscard]] inline double log_volume(double e) {
  const double J = 1 + e;
  return std::log(J) + (e - (J - 1)) / J;
}

/// ln(1 + x) − x without cancellation; the leading term is −x²/2. Uses ln(1 + x) = 2 artanh s with
/// s = x/(2 + x) and 2s − x = −s x.
[[nodiscard]] inline double log1p_minus(double x) {
  if (!(std::abs(x) < 0.25)) return log_volume(x) - x;
  const double s = x / (2 + x);
  const double square = s * s;
  double series = 0.0;
  for (int k = 21; k >= 3; k -= 2) series = square * (series + 1.0 / k);
  return s * (2 * series - x);
}

template <>
struct Numbers<double> {
  using Mask = bool;
  static double all(double value) { return value; }
  static bool everywhere(bool mask) { return mask; }
  static double magnitude(double value) { return std::abs(value); }
  static double root(double value) { return std::sqrt(value); }
  /// ln J and 1/J from e = J − 1; `good` is lost where J ≤ 0 or is not finite.
  static double log_and_inverse(double e, double& inverse, bool& good) {
    const double J = 1 + e;
    inverse = 1 / J;
    good = good && J > 0.0 && J < huge;
    return std::log(J) + (e - (J - 1)) * inverse;
  }
  static double log_minus(double e) { return log1p_minus(e); }
};

}  // namespace tlsph

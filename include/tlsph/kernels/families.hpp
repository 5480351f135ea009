#pragma once
/// \file
/// Kernels ("cover functions" in the thesis). A family is a stateless struct with the shape w(q)
/// and its first two derivatives on 0 ≤ q < 1, q = r/h, h the **full support radius**, and the
/// constant α_d that makes ∫ W dV = 1 for W(r) = α_d w(r/h)/h^d in d dimensions. Families that the
/// literature writes with support 2h appear here with q̂ = 2q. A new family is one struct, one entry
/// in `AnyKernel` and one entry in the typed tests.

#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace tlsph {

template <class K>
concept KernelFamily = requires(double q) {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::shape(q) } -> std::same_as<double>;
  { K::first(q) } -> std::same_as<double>;          // dw/dq
  { K::second(q) } -> std::same_as<double>;         // d²w/dq²
  { K::normalisation(1) } -> std::same_as<double>;  // α_d for d = 1, 2, 3
};

namespace detail {
/// x^n for a small n known at compile time.
template <int N>
constexpr double power(double x) {
  if constexpr (N == 0)
    return 1.0;
  else
    return x * power<N - 1>(x);
}

/// Picks α_d; d = 1, 2 or 3.
constexpr double by_dimension(int d, double one, double two, double three) {
  return d == 1 ? one : d == 2 ? two : three;
}

}  // namespace detail

/// W(r) [m^(−D)] at distance r ≥ 0 [m], support radius h [m]; zero for r ≥ h.
template <int D, KernelFamily K>
[[nodiscard]] double kernel_value(const K&, double r, double h) {
  if (r >= h) return 0.0;
  return K::normalisation(D) * K::shape(r / h) / detail::power<D>(h);
}

/// dW/dr [m^(−D−1)]; zero for r ≥ h.
template <int D, KernelFamily K>
[[nodiscard]] double kernel_first(const K&, double r, double h) {
  if (r >= h) return 0.0;
  return K::normalisation(D) * K::first(r / h) / detail::power<D + 1>(h);
}

/// d²W/dr² [m^(−D−2)]; zero for r ≥ h.
template <int D, KernelFamily K>
[[nodiscard]] double kernel_second(const K&, double r, double h) {
  if (r >= h) return 0.0;
  return K::normalisation(D) * K::second(r / h) / detail::power<D + 2>(h);
}

/// (1 + 3q)(1 − q)³.
struct Lucy {
  static constexpr std::string_view name = "lucy";
  static double shape(double q) { return (1 + 3 * q) * detail::power<3>(1 - q); }
  static double first(double q) { return -12 * q * detail::power<2>(1 - q); }
  static double second(double q) { return -12 * (1 - q) * (1 - 3 * q); }
  static double normalisation(int d) {
    return detail::by_dimension(d, 5.0 / 4, 5 / std::numbers::pi, 105 / (16 * std::numbers::pi));
  }
};

/// The cubic B-spline M₄: 1 − 6q² + 6q³ up to q = 1/2, then 2(1 − q)³.
struct CubicSpline {
  static constexpr std::string_view name = "cubic-spline";
  static double shape(double q) {
    return q < 0.5 ? 1 - 6 * q * q * (1 - q) : 2 * detail::power<3>(1 - q);
  }
  static double first(double q) {
    return q < 0.5 ? q * (18 * q - 12) : -6 * detail::power<2>(1 - q);
  }
  static double second(double q) { return q < 0.5 ? 36 * q - 12 : 12 * (1 - q); }
  static double normalisation(int d) {
    return detail::by_dimension(d, 4.0 / 3, 40 / (7 * std::numbers::pi), 8 / std::numbers::pi);
  }
};

/// exp(−9q²), cut off at the support (where it is 1.2e-4) and renormalised over it, so ∫W = 1 holds
/// exactly although the tail is missing. It and its derivatives jump by that much at r = h.
struct Gaussian {
  static constexpr std::string_view name = "gaussian";
  static double shape(double q) { return std::exp(-9 * q * q); }
  static double first(double q) { return -18 * q * shape(q); }
  static double second(double q) { return (324 * q * q - 18) * shape(q); }
  /// 3/(√π erf 3), 9/(π(1 − e⁻⁹)) and 1/(4π[√π erf(3)/108 − e⁻⁹/18]), to 40 digits and rounded.
  static double normalisation(int d) {
    return detail::by_dimension(d, 1.692606141154149813877, 2.865142562336414387788,
                                4.850986001888353777109);
  }
};

namespace detail {
/// exp(−1/(1 − q²)) and s = 1 − q²; at the support both are zero. Derivatives carry at most s⁻⁴,
/// and the exponential is below 1e-300 long before that matters, so all products stay finite.
struct Bump {
  double s;
  double e;
  explicit Bump(double q) : s((1 - q) * (1 + q)), e(s > 0 ? std::exp(-1 / s) : 0.0) {}
};
}  // namespace detail

/// exp(−1/(1 − q²)), infinitely smooth.
struct Mollifier {
  static constexpr std::string_view name = "mollifier";
  static double shape(double q) { return detail::Bump(q).e; }
  static double first(double q) {
    const auto [s, e] = detail::Bump(q);
    return e > 0 ? -2 * q * e / (s * s) : 0.0;
  }
  static double second(double q) {
    const auto [s, e] = detail::Bump(q);
    return e > 0 ? e * (4 * q * q - 8 * q * q * s - 2 * s * s) / detail::power<4>(s) : 0.0;
  }
  /// No closed form; tanh–sinh quadrature in 40-digit arithmetic, rounded.
  static double normalisation(int d) {
    return detail::by_dimension(d, 2.252283621043581010500, 2.143565775792236601001,
                                2.267116739608326458418);
  }
};

/// exp(−1/(1 − q²)) (1 − q²)⁸, the thesis's own kernel.
struct ModifiedMollifier {
  static constexpr std::string_view name = "modified-mollifier";
  static double shape(double q) {
    const auto [s, e] = detail::Bump(q);
    return e * detail::power<8>(s);
  }
  static double first(double q) {
    const auto [s, e] = detail::Bump(q);
    return -2 * q * e * detail::power<6>(s) * (1 + 8 * s);
  }
  static double second(double q) {
    const auto [s, e] = detail::Bump(q);
    return 2 * e * detail::power<4>(s) *
           (2 * q * q * (1 + 14 * s + 56 * s * s) - s * s * (1 + 8 * s));
  }
  /// No closed form; tanh–sinh quadrature in 40-digit arithmetic, rounded.
  static double normalisation(int d) {
    return detail::by_dimension(d, 4.809676978488161327354, 8.746220211747463182652,
                                16.32220830375109706053);
  }
};

/// Johnson's quadratic 3/16 q̂² − 3/4 q̂ + 3/4 with q̂ = 2q, that is 3/4 (1 − q)²: its slope grows
/// towards the centre, so close particles still repel. It has a kink at r = 0.
struct Quadratic {
  static constexpr std::string_view name = "quadratic";
  static double shape(double q) { return 0.75 * (1 - q) * (1 - q); }
  static double first(double q) { return -1.5 * (1 - q); }
  static double second(double) { return 1.5; }
  static double normalisation(int d) {
    return detail::by_dimension(d, 2.0, 8 / std::numbers::pi, 10 / std::numbers::pi);
  }
};

/// (1 − q)⁴(1 + 4q), positive definite in up to three dimensions; the same shape in all of them.
struct WendlandC2 {
  static constexpr std::string_view name = "wendland-c2";
  static double shape(double q) { return detail::power<4>(1 - q) * (1 + 4 * q); }
  static double first(double q) { return -20 * q * detail::power<3>(1 - q); }
  static double second(double q) { return -20 * detail::power<2>(1 - q) * (1 - 4 * q); }
  static double normalisation(int d) {
    return detail::by_dimension(d, 3.0 / 2, 7 / std::numbers::pi, 21 / (2 * std::numbers::pi));
  }
};

/// Every family, listed once; visited outside the loops.
using AnyKernel =
    std::variant<Lucy, CubicSpline, Gaussian, Mollifier, ModifiedMollifier, Quadratic, WendlandC2>;

/// W and dW/dr of whichever family it is.
template <int D>
[[nodiscard]] double kernel_value(const AnyKernel& kernel, double r, double h) {
  return std::visit([&](const auto& family) { return kernel_value<D>(family, r, h); }, kernel);
}
template <int D>
[[nodiscard]] double kernel_first(const AnyKernel& kernel, double r, double h) {
  return std::visit([&](const auto& family) { return kernel_first<D>(family, r, h); }, kernel);
}

/// The family a scene calls `name`; empty if there is none.
[[nodiscard]] std::optional<AnyKernel> kernel_by_name(std::string_view name);

/// The names of all families, in the order of `AnyKernel`.
[[nodiscard]] std::vector<std::string_view> kernel_names();

}  // namespace tlsph

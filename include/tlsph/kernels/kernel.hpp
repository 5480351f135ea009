#pragma once
/// \file
/// Kernels ("cover functions" in the thesis). A family is a stateless struct with the shape w(q)
/// and its first two derivatives on 0 ≤ q < 1, q = r/h, h the **full support radius**, and the
/// constant α_d that makes ∫ W dV = 1 for W(r) = α_d w(r/h)/h^d in d dimensions.
///
/// The families and the variant that lists them are in kernels/families.hpp; here is what a family
/// is and how the kernel W and its derivatives come from it.

#include <concepts>
#include <string_view>

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

}  // namespace tlsph

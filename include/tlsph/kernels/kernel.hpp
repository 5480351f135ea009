#pragma once
/// \file
/// Kernels ("cover functions" in the thesis). A family is a stateless struct with the shape w(q) and
/// its first two derivatives on 0 ≤ q < 1, q = r/h, h the **full support radius**, and the constant
/// α_d that makes ∫ W dV = 1 for W(r) = α_d w(r/h)/h^d in d dimensions.

#include <array>
#include <concepts>
#include <string_view>
#include <variant>
#include <vector>

namespace tlsph {

template <class K>
concept KernelFamily = requires(double q) {
  { K::name } -> std::convertible_to<std::string_view>;
  { K::shape(q) } -> std::same_as<double>;
  { K::first(q) } -> std::same_as<double>;   // dw/dq
  { K::second(q) } -> std::same_as<double>;  // d²w/dq²
  { K::normalisation(1) } -> std::same_as<double>;  // α_d for d = 1, 2, 3
};

// The families are in kernels/families.hpp:
struct Lucy;
struct CubicSpline;
struct Gaussian;
struct Mollifier;
struct ModifiedMollifier;
struct Quadratic;
struct WendlandC2;

}  // namespace tlsph

#pragma once
/// \file
/// Bodies that are drawn out: the stress the law wants, and how far from it a run is.

#include <span>

#include "tlsph/materials/lame.hpp"

namespace tlsph {

/// Cauchy stress [Pa] along the first principal stretch of a Neo-Hookean body in plane strain,
/// (5.5) of the thesis with λ₃ = 1.
[[nodiscard]] double neo_hookean_cauchy(const Lame& constants, double first, double second);

/// The smallest first stretch > 1 at which a Neo-Hookean body in plane strain carries no waves any
/// more along it: ∂P₁/∂F₁₁ = μ(1 + 1/λ₁²) + λ(1 − ln λ₁λ₂)/λ₁² = 0. Infinite if there is none below
/// 10.
[[nodiscard]] double hyperbolic_limit(const Lame& constants, double second);

/// The largest |observed/expected − 1| where `stretch` is between `from` and `to`.
[[nodiscard]] double largest_deviation(std::span<const double> stretch,
                                       std::span<const double> observed,
                                       std::span<const double> expected, double from, double to);

}  // namespace tlsph

#pragma once
/// \file
/// Bodies that are drawn out: the stress the law wants, and how far from it a run is.

#include <functional>
#include <span>

#include "tlsph/materials/lame.hpp"

namespace tlsph {

/// Cauchy stress [Pa] along the first principal stretch of a Neo-Hookean body in plane strain,
/// (5.5) of the thesis with λ₃ = 1.
[[nodiscard]] double neo_hookean_cauchy(const Lame& constants, double first, double second);

/// Where `function` falls below zero first on the way from 1 to 10; infinite if nowhere.
[[nodiscard]] double first_loss(const std::function<double(double)>& function);

/// The largest |observed/expected − 1| where `stretch` is between `from` and `to`.
[[nodiscard]] double largest_deviation(std::span<const double> stretch,
                                       std::span<const double> observed,
                                       std::span<const double> expected, double from, double to);

}  // namespace tlsph

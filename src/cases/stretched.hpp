#pragma once
/// \file
/// Bodies that are drawn out: the stress the law wants, and how far from it a run is.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "tlsph/materials/lame.hpp"

namespace tlsph {

/// Cauchy stress [Pa] along the first principal stretch of a Neo-Hookean body in plane strain,
/// (5.5) of the thesis with λ₃ = 1.
[[nodiscard]] inline double neo_hookean_cauchy(const Lame& constants, double first, double second) {
  const double J = first * second;
  return (constants.mu * (first * first - 1) + constants.lambda * std::log(J)) / J;
}

/// Where `function` falls below zero first on the way from 1 to 10; infinite if nowhere.
template <class Function>
[[nodiscard]] double first_loss(const Function& function) {
  constexpr double step = 0.01;
  for (double lower = 1.0; lower < 10.0; lower += step) {
    if (function(lower + step) >= 0) continue;
    double upper = lower + step;
    while (upper - lower > 1e-12) {
      const double middle = 0.5 * (lower + upper);
      (function(middle) >= 0 ? lower : upper) = middle;
    }
    return lower;
  }
  return std::numeric_limits<double>::infinity();
}

/// The largest |observed/expected − 1| where `stretch` is between 1.2 and `to`.
[[nodiscard]] inline double largest_deviation(std::span<const double> stretch,
                                              std::span<const double> observed,
                                              std::span<const double> expected, double to) {
  double largest = 0.0;
  for (std::size_t k = 0; k < stretch.size(); ++k)
    if (stretch[k] >= 1.2 && stretch[k] <= to)
      largest = std::max(largest, std::abs(observed[k] / expected[k] - 1));
  return largest;
}

}  // namespace tlsph

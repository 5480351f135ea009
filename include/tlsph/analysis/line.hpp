#pragma once
/// \file
/// The straight line through points.

#include <span>

#include "tlsph/analysis/not_known.hpp"

namespace tlsph {

/// y = c + p x. Not a number where there are too few points for it: two, of the error three.
struct LineFit {
  double slope = not_known;           ///< p
  double intercept = not_known;       ///< c
  double standard_error = not_known;  ///< of p
};

/// By least squares.
[[nodiscard]] LineFit fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace tlsph

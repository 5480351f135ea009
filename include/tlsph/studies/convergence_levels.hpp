#pragma once
/// \file
/// From the runs of a series to what they show: how samples scatter, the orders, the limits.

#include <span>

#include "tlsph/studies/converge.hpp"

namespace tlsph {

/// Best, median and worst of errors; a failure is an infinite error, what is not a number does not
/// count. The median of an even number is the mean of the middle two.
[[nodiscard]] Spread spread_of(std::vector<double> errors);

/// The levels of one series, whose rows stand from coarse to fine with samples side by side; their
/// orders, and the fit of each quantity. Errors of method `probes` are differences.
struct SeriesOrders {
  std::vector<ConvergenceLevel> levels;
  std::vector<ConvergenceFit> fits;
};
[[nodiscard]] SeriesOrders find_orders(std::span<const ConvergenceRow> rows,
                                       const std::vector<std::string>& quantities,
                                       ConvergenceMethod method);

/// The values of one series and their limits, one a name.
[[nodiscard]] std::vector<ConvergenceValue> find_limits(std::span<const ConvergenceRow> rows,
                                                        const std::vector<std::string>& names);

}  // namespace tlsph

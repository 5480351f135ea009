#include "stretched.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tlsph {

double neo_hookean_cauchy(const Lame& constants, double first, double second) {
  const double J = first * second;
  return (constants.mu * (first * first - 1) + constants.lambda * std::log(J)) / J;
}

double first_loss(const std::function<double(double)>& function) {
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

double largest_deviation(std::span<const double> stretch, std::span<const double> observed,
                         std::span<const double> expected, double from, double to) {
  double largest = 0.0;
  for (std::size_t k = 0; k < stretch.size(); ++k)
    if (stretch[k] >= from && stretch[k] <= to)
      largest = std::max(largest, std::abs(observed[k] / expected[k] - 1));
  return largest;
}

}  // namespace tlsph

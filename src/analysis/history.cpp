#include "tlsph/analysis/history.hpp"

#include <algorithm>
#include <cassert>

namespace tlsph {

std::vector<double> resample(std::span<const double> time, std::span<const double> values,
                             std::span<const double> at) {
  assert(!time.empty() && time.size() == values.size());
  const std::size_t n = time.size();
  const std::size_t stencil = std::min<std::size_t>(4, n);
  std::vector<double> result;
  result.reserve(at.size());
  for (const double t : at) {
    if (t <= time.front() || t >= time.back()) {
      result.push_back(t <= time.front() ? values.front() : values.back());
      continue;
    }
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    // Two samples on either side where there are two.
    const std::size_t first = std::min(after > 2 ? after - 2 : 0, n - stencil);
    double sum = 0.0;
    for (std::size_t i = first; i < first + stencil; ++i) {
      double weight = 1.0;  // Lagrange
      for (std::size_t j = first; j < first + stencil; ++j)
        if (j != i) weight *= (t - time[j]) / (time[i] - time[j]);
      sum += weight * values[i];
    }
    result.push_back(sum);
  }
  return result;
}

double squared_norm(std::span<const double> time, std::span<const double> values) {
  assert(time.size() == values.size());
  double sum = 0.0;
  for (std::size_t k = 1; k < time.size(); ++k)
    sum += 0.5 * (time[k] - time[k - 1]) * (values[k] * values[k] + values[k - 1] * values[k - 1]);
  return sum;
}

}  // namespace tlsph

#include "signals.hpp"

#include <algorithm>
#include <cmath>

namespace tlsph {

double arrival(std::span<const double> time, std::span<const double> values, double share) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const double level = share * largest;
  for (std::size_t k = 1; k < time.size(); ++k) {
    const double a = std::abs(values[k - 1]);
    const double b = std::abs(values[k]);
    if (b >= level && b > a) return time[k - 1] + (time[k] - time[k - 1]) * (level - a) / (b - a);
  }
  return time.back();
}

double peak(std::span<const double> time, std::span<const double> values, double from, double to) {
  double largest = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= from && time[k] <= to) largest = std::max(largest, std::abs(values[k]));
  return largest;
}

}  // namespace tlsph

#include "signals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tlsph/analysis/history.hpp"

namespace tlsph {

double reaches(std::span<const double> time, std::span<const double> values, double level) {
  for (std::size_t k = 1; k < time.size(); ++k) {
    const double a = std::abs(values[k - 1]);
    const double b = std::abs(values[k]);
    if (b >= level && b > a) return time[k - 1] + (time[k] - time[k - 1]) * (level - a) / (b - a);
  }
  return time.back();
}

double arrival(std::span<const double> time, std::span<const double> values, double share) {
  return reaches(time, values, share * peak(time, values, time.front(), time.back()));
}

double peak(std::span<const double> time, std::span<const double> values, double from, double to) {
  double largest = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= from && time[k] <= to) largest = std::max(largest, std::abs(values[k]));
  return largest;
}

double mean(std::span<const double> time, std::span<const double> values, double from, double to) {
  double integral = 0.0;
  double length = 0.0;
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k - 1] < from || time[k] > to) continue;
    integral += 0.5 * (values[k - 1] + values[k]) * (time[k] - time[k - 1]);
    length += time[k] - time[k - 1];
  }
  return integral / length;
}

double largest_difference(std::span<const double> values, std::span<const double> exact) {
  double largest = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
    largest = std::max(largest, std::abs(values[k] - exact[k]));
  return largest;
}

double relative_error(std::span<const double> time, std::span<const double> values,
                      std::span<const double> exact) {
  std::vector<double> difference(values.begin(), values.end());
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= exact[k];
  return std::sqrt(squared_norm(time, difference) / squared_norm(time, exact));
}

}  // namespace tlsph

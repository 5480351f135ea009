#include "samples.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tlsph/analysis/history.hpp"

namespace tlsph {

double reaches(const Samples& samples, double level) {
  const auto& [time, values] = samples;
  for (std::size_t k = 1; k < time.size(); ++k) {
    const double a = std::abs(values[k - 1]);
    const double b = std::abs(values[k]);
    if (b >= level && b > a) return time[k - 1] + (time[k] - time[k - 1]) * (level - a) / (b - a);
  }
  return time.back();
}

double arrival(const Samples& samples, double share) {
  return reaches(samples, share * peak(samples));
}

double peak(const Samples& samples, double end) {
  double largest = 0.0;
  for (std::size_t k = 0; k < samples.time.size() && samples.time[k] <= end; ++k)
    largest = std::max(largest, std::abs(samples.values[k]));
  return largest;
}

double mean(const Samples& samples, double from, double to) {
  const auto& [time, values] = samples;
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
  assert(values.size() <= exact.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k)
    largest = std::max(largest, std::abs(values[k] - exact[k]));
  return largest;
}

double relative_error(const Samples& samples, std::span<const double> exact) {
  std::vector<double> difference(samples.values.begin(), samples.values.end());
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= exact[k];
  return std::sqrt(squared_norm(samples.time, difference) / squared_norm(samples.time, exact));
}

double relative_error(const CaseScene& scene, std::string_view column) {
  return relative_error(scene.samples(column), scene.exact_samples(column).values);
}

}  // namespace tlsph

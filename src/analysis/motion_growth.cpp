#include "tlsph/analysis/motion_growth.hpp"

#include <algorithm>
#include <cmath>

#include "tlsph/analysis/line.hpp"
#include "tlsph/analysis/not_known.hpp"

namespace tlsph {

double growth_rate(const std::vector<std::complex<double>>& squared_frequencies) {
  double rate = 0.0;
  for (const std::complex<double>& square : squared_frequencies)
    rate = std::max(rate, std::abs(std::sqrt(-square).real()));
  return rate;
}

double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies, double dt) {
  double largest = 0.0;
  for (const std::complex<double>& square : squared_frequencies) {
    // The roots of z² − 2bz + 1 are inverse to each other: either sign will do.
    const std::complex<double> b = 1.0 - 0.5 * square * dt * dt;
    largest = std::max(largest, std::abs(std::log(std::abs(b + std::sqrt(b * b - 1.0)))));
  }
  return largest;
}

double growth_rate(std::span<const double> time, std::span<const double> values, double low,
                   double high) {
  std::size_t first = 0;
  while (first < values.size() && !(values[first] >= low)) ++first;
  std::size_t last = first;
  while (last < values.size() && values[last] < high) ++last;
  if (last == values.size() || last - first < 3) return not_known;
  std::vector<double> logarithms;
  for (std::size_t k = first; k < last; ++k) logarithms.push_back(std::log(values[k]));
  return fit_line(time.subspan(first, last - first), logarithms).slope;
}

}  // namespace tlsph

#include "motion_growth.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace tlsph

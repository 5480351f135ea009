#include "tlsph/exact/named_fields.hpp"

#include <cmath>

namespace tlsph {

namespace {

constexpr double kappa = cantilever_wave_number;

double sigma() {
  return (std::cosh(kappa) + std::cos(kappa)) / (std::sinh(kappa) + std::sin(kappa));
}

}  // namespace

double cantilever_mode(double xi) {
  const double s = kappa * xi;
  return 0.5 * (std::cosh(s) - std::cos(s) - sigma() * (std::sinh(s) - std::sin(s)));
}

double cantilever_mode_slope(double xi) {
  const double s = kappa * xi;
  return 0.5 * kappa * (std::sinh(s) + std::sin(s) - sigma() * (std::cosh(s) - std::cos(s)));
}

}  // namespace tlsph

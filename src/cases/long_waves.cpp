#include "long_waves.hpp"

#include <cmath>
#include <numbers>

#include "vibration.hpp"

namespace tlsph {

double long_wave_lag(const Discretisation<1>& bar, double dt) {
  // Small enough for the leading term, large enough for its digits.
  const double theta = 0.02;
  const double k = theta / bar.spacing;
  const double omega = std::sqrt(squared_frequency(bar, bar.nodes() / 2, k));
  const double courant = bar.wave_speed() * dt / bar.spacing;
  return (1.0 - omega / (bar.wave_speed() * k)) / (theta * theta) - courant * courant / 24.0;
}

double pulse_dispersion_error(double a, double spacing, double x, const PulseCurve& pulse,
                              double speed) {
  const double sigma = speed * pulse.rise;
  const double length = speed * pulse.duration;
  // Both flanks are erf(s)/2 with s = x/σ; ∫ (4s² − 2)² e^{−2s²} ds = 3 √(π/2).
  const double third =
      2.0 * 3.0 * std::sqrt(std::numbers::pi / 2.0) / (std::numbers::pi * std::pow(sigma, 5));
  const double norm = length - sigma * std::sqrt(2.0 / std::numbers::pi);
  return std::abs(a) * spacing * spacing * x * std::sqrt(third / norm);
}

}  // namespace tlsph

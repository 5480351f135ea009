#include "tlsph/curves/curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace tlsph {

namespace {

constexpr double pi = std::numbers::pi;

// --- constant -----------------------------------------------------------------------------------

double value_of(const ConstantCurve& curve, double) {
  return curve.amplitude;
}
double rate_of(const ConstantCurve&, double) {
  return 0.0;
}
double integral_of(const ConstantCurve& curve, double t) {
  return curve.amplitude * t;
}

// --- ramp, in s = t/rise ------------------------------------------------------------------------

double value_of(const RampCurve& curve, double t) {
  if (t >= curve.rise) return curve.amplitude;
  const double s = t / curve.rise;
  return curve.amplitude * (curve.smooth ? s * s * s * (10 + s * (6 * s - 15)) : s);
}

double rate_of(const RampCurve& curve, double t) {
  if (t >= curve.rise) return 0.0;
  const double s = t / curve.rise;
  const double slope = curve.smooth ? 30 * s * s * (1 - s) * (1 - s) : 1.0;
  return curve.amplitude / curve.rise * slope;
}

double integral_of(const RampCurve& curve, double t) {
  // either ramp is point symmetric about its middle and fills half of amplitude × rise
  if (t >= curve.rise) return curve.amplitude * (t - 0.5 * curve.rise);
  const double s = t / curve.rise;
  const double area = curve.smooth ? s * s * s * s * (2.5 + s * (s - 3)) : 0.5 * s * s;
  return curve.amplitude * curve.rise * area;
}

// --- pulse, with x = (t − 3r)/r at the rising and x − T/r at the falling flank
// ------------------------------

/// ∫ erfc(−x) dx from −∞: e^(−x²)/√π + x erfc(−x); → 0 for x → −∞ and → 2x for x → ∞.
double integrated_step(double x) {
  return std::exp(-x * x) * std::numbers::inv_sqrtpi + x * std::erfc(-x);
}

double value_of(const PulseCurve& curve, double t) {
  if (curve.rise <= 0) return t < curve.duration ? curve.amplitude : 0.0;
  const double on = (t - 3 * curve.rise) / curve.rise;
  const double off = on - curve.duration / curve.rise;
  // equal to the difference of erf, which loses the small values before the pulse to cancellation
  return 0.5 * curve.amplitude *
         (off > 0 ? std::erfc(off) - std::erfc(on) : std::erfc(-on) - std::erfc(-off));
}

double rate_of(const PulseCurve& curve, double t) {
  if (curve.rise <= 0) return 0.0;
  const double on = (t - 3 * curve.rise) / curve.rise;
  const double off = on - curve.duration / curve.rise;
  return curve.amplitude * std::numbers::inv_sqrtpi / curve.rise *
         (std::exp(-on * on) - std::exp(-off * off));
}

double integral_of(const PulseCurve& curve, double t) {
  if (curve.rise <= 0) return curve.amplitude * std::min(t, curve.duration);
  const double on = (t - 3 * curve.rise) / curve.rise;
  const double length = curve.duration / curve.rise;
  const auto both = [length](double x) { return integrated_step(x) - integrated_step(x - length); };
  return 0.5 * curve.amplitude * curve.rise * (both(on) - both(-3.0));
}

// --- sine² --------------------------------------------------------------------------------------

double value_of(const SineSquaredCurve& curve, double t) {
  if (t >= curve.duration) return 0.0;
  const double sine = std::sin(pi * t / curve.duration);
  return curve.amplitude * sine * sine;
}

double rate_of(const SineSquaredCurve& curve, double t) {
  if (t >= curve.duration) return 0.0;
  return curve.amplitude * pi / curve.duration * std::sin(2 * pi * t / curve.duration);
}

double integral_of(const SineSquaredCurve& curve, double t) {
  if (t >= curve.duration) return 0.5 * curve.amplitude * curve.duration;
  const double angle = 2 * pi * t / curve.duration;
  return curve.amplitude * curve.duration / (4 * pi) * (angle - std::sin(angle));
}

// --- table --------------------------------------------------------------------------------------

/// The number of entries at or before t.
std::size_t entries_until(const TableCurve& curve, double t) {
  const auto after = std::upper_bound(curve.time.begin(), curve.time.end(), t);
  return static_cast<std::size_t>(std::distance(curve.time.begin(), after));
}

double slope(const TableCurve& curve, std::size_t next) {
  return (curve.value[next] - curve.value[next - 1]) / (curve.time[next] - curve.time[next - 1]);
}

double value_of(const TableCurve& curve, double t) {
  if (curve.time.empty()) return 0.0;
  const std::size_t next = entries_until(curve, t);
  if (next == 0) return curve.value.front();
  if (next == curve.time.size()) return curve.value.back();
  return curve.value[next - 1] + slope(curve, next) * (t - curve.time[next - 1]);
}

double rate_of(const TableCurve& curve, double t) {
  const std::size_t next = entries_until(curve, t);
  return next == 0 || next == curve.time.size() ? 0.0 : slope(curve, next);
}

double integral_of(const TableCurve& curve, double t) {
  // trapezia between 0, the entries in between, and t
  double sum = 0.0, from = 0.0, at_from = value_of(curve, 0.0);
  for (std::size_t k = entries_until(curve, 0.0); k < curve.time.size(); ++k) {
    if (curve.time[k] > t) break;
    // a jump is two entries at one time: the first ends the trapezium, the second starts the next
    sum += 0.5 * (at_from + curve.value[k]) * (curve.time[k] - from);
    from = curve.time[k];
    at_from = curve.value[k];
  }
  return sum + 0.5 * (at_from + value_of(curve, t)) * (t - from);
}

}  // namespace

double value(const Curve& curve, double t) {
  if (t < 0) return 0.0;
  return std::visit([t](const auto& form) { return value_of(form, t); }, curve);
}

double rate(const Curve& curve, double t) {
  if (t < 0) return 0.0;
  return std::visit([t](const auto& form) { return rate_of(form, t); }, curve);
}

double integral(const Curve& curve, double t) {
  if (t <= 0) return 0.0;
  return std::visit([t](const auto& form) { return integral_of(form, t); }, curve);
}

}  // namespace tlsph

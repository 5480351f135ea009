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

// Between entries 0 and 1 with t = t₀ + s Δ:
//   value = (1−s) y₀ + s y₁ + Δ²/6 [((1−s)³ − (1−s)) y″₀ + (s³ − s) y″₁]

/// A table between the entries next − 1 and next.
struct Piece {
  double width, low, high, low_curvature, high_curvature;

  Piece(const TableCurve& curve, std::size_t next)
      : width(curve.time[next] - curve.time[next - 1]),
        low(curve.value[next - 1]),
        high(curve.value[next]),
        low_curvature(curve.curvature.empty() ? 0.0 : curve.curvature[next - 1]),
        high_curvature(curve.curvature.empty() ? 0.0 : curve.curvature[next]) {}

  [[nodiscard]] double value(double s) const {
    const double r = 1 - s;
    return low + s * (high - low) +
           width * width / 6 * (r * (r * r - 1) * low_curvature + s * (s * s - 1) * high_curvature);
  }
  [[nodiscard]] double rate(double s) const {
    const double r = 1 - s;
    return (high - low) / width +
           width / 6 * ((1 - 3 * r * r) * low_curvature + (3 * s * s - 1) * high_curvature);
  }
  /// ∫ value dt from entry 0 to s.
  [[nodiscard]] double area(double s) const {
    const double r = 1 - s, r2 = r * r, s2 = s * s;
    return width * (s * low + 0.5 * s2 * (high - low)) -
           width * width * width / 24 *
               ((1 - r2) * (1 - r2) * low_curvature + s2 * (2 - s2) * high_curvature);
  }
};

double value_of(const TableCurve& curve, double t) {
  if (curve.time.empty()) return 0.0;
  const std::size_t next = entries_until(curve, t);
  if (next == 0) return curve.value.front();
  if (next == curve.time.size()) return curve.value.back();
  const Piece piece(curve, next);
  return piece.value((t - curve.time[next - 1]) / piece.width);
}

double rate_of(const TableCurve& curve, double t) {
  const std::size_t next = entries_until(curve, t);
  if (next == 0 || next == curve.time.size()) return 0.0;
  const Piece piece(curve, next);
  return piece.rate((t - curve.time[next - 1]) / piece.width);
}

/// ∫ value from the first entry to t.
double area_until(const TableCurve& curve, double t) {
  if (t < curve.time.front()) return curve.value.front() * (t - curve.time.front());
  double sum = 0.0;
  for (std::size_t next = 1; next < curve.time.size() && curve.time[next - 1] <= t; ++next) {
    const Piece piece(curve, next);
    if (piece.width > 0.0)
      sum += piece.area(std::min(1.0, (t - curve.time[next - 1]) / piece.width));
  }
  return sum + curve.value.back() * std::max(0.0, t - curve.time.back());
}

double integral_of(const TableCurve& curve, double t) {
  return curve.time.empty() ? 0.0 : area_until(curve, t) - area_until(curve, 0.0);
}

// --- given --------------------------------------------------------------------------------------

double value_of(const GivenCurve& curve, double t) {
  return curve.value(t);
}
double rate_of(const GivenCurve& curve, double t) {
  return curve.rate(t);
}
double integral_of(const GivenCurve& curve, double t) {
  return curve.integral(t);
}

// --- splines ------------------------------------------------------------------------------------

/// Curvatures of a natural spline through the entries [first, last]: elimination of
///   Δ₋ y″₋ + 2 (Δ₋ + Δ₊) y″ + Δ₊ y″₊ = 6 (slope₊ − slope₋),  zero at both ends.
void fit_spline(TableCurve& curve, std::size_t first, std::size_t last) {
  std::vector<double> ratio(last - first + 1, 0.0);  // y″ = y″ so far − ratio y″₊
  const auto width = [&](std::size_t k) { return curve.time[k + 1] - curve.time[k]; };
  const auto slope = [&](std::size_t k) {
    return (curve.value[k + 1] - curve.value[k]) / width(k);
  };
  for (std::size_t k = first + 1; k < last; ++k) {
    const double before = width(k - 1), after = width(k);
    const double pivot = 2 * (before + after) - before * ratio[k - 1 - first];
    ratio[k - first] = after / pivot;
    curve.curvature[k] = (6 * (slope(k) - slope(k - 1)) - before * curve.curvature[k - 1]) / pivot;
  }
  for (std::size_t k = last; k-- > first + 1;)
    curve.curvature[k] -= ratio[k - first] * curve.curvature[k + 1];
}

}  // namespace

TableCurve cubic_spline(TableCurve table) {
  table.curvature.assign(table.time.size(), 0.0);
  std::size_t first = 0;
  for (std::size_t k = 1; k <= table.time.size(); ++k) {
    if (k < table.time.size() && table.time[k] > table.time[k - 1]) continue;
    fit_spline(table, first, k - 1);
    first = k;
  }
  return table;
}

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

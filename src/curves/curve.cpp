#include "tlsph/curves/curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tlsph {

// --- ramp, in s = t/rise ------------------------------------------------------------------------

double RampCurve::value(double t) const {
  if (t >= rise) return amplitude;
  const double s = t / rise;
  return amplitude * (smooth ? s * s * s * (10 + s * (6 * s - 15)) : s);
}

double RampCurve::rate(double t) const {
  if (t >= rise) return 0.0;
  const double s = t / rise;
  const double slope = smooth ? 30 * s * s * (1 - s) * (1 - s) : 1.0;
  return amplitude / rise * slope;
}

double RampCurve::integral(double t) const {
  // either ramp is point symmetric about its middle and fills half of amplitude × rise
  if (t >= rise) return amplitude * (t - 0.5 * rise);
  const double s = t / rise;
  const double area = smooth ? s * s * s * s * (2.5 + s * (s - 3)) : 0.5 * s * s;
  return amplitude * rise * area;
}

// --- pulse, with x = (t − 3r)/r at the rising and x − T/r at the falling flank -------------------

namespace {

/// ∫ erfc(−x) dx from −∞: e^(−x²)/√π + x erfc(−x); → 0 for x → −∞ and → 2x for x → ∞.
double integrated_step(double x) {
  return std::exp(-x * x) * std::numbers::inv_sqrtpi + x * std::erfc(-x);
}

}  // namespace

double PulseCurve::value(double t) const {
  if (rise <= 0) return t < duration ? amplitude : 0.0;
  const double on = (t - 3 * rise) / rise;
  const double off = on - duration / rise;
  // equal to the difference of erf, which loses the small values before the pulse to cancellation
  return 0.5 * amplitude *
         (off > 0 ? std::erfc(off) - std::erfc(on) : std::erfc(-on) - std::erfc(-off));
}

double PulseCurve::rate(double t) const {
  if (rise <= 0) return 0.0;
  const double on = (t - 3 * rise) / rise;
  const double off = on - duration / rise;
  return amplitude * std::numbers::inv_sqrtpi / rise * (std::exp(-on * on) - std::exp(-off * off));
}

double PulseCurve::integral(double t) const {
  if (rise <= 0) return amplitude * std::min(t, duration);
  const double on = (t - 3 * rise) / rise;
  const double length = duration / rise;
  const auto both = [length](double x) { return integrated_step(x) - integrated_step(x - length); };
  return 0.5 * amplitude * rise * (both(on) - both(-3.0));
}

// --- sine² --------------------------------------------------------------------------------------

double SineSquaredCurve::value(double t) const {
  if (t >= duration) return 0.0;
  const double sine = std::sin(std::numbers::pi * t / duration);
  return amplitude * sine * sine;
}

double SineSquaredCurve::rate(double t) const {
  if (t >= duration) return 0.0;
  return amplitude * std::numbers::pi / duration * std::sin(2 * std::numbers::pi * t / duration);
}

double SineSquaredCurve::integral(double t) const {
  if (t >= duration) return 0.5 * amplitude * duration;
  const double angle = 2 * std::numbers::pi * t / duration;
  return amplitude * duration / (4 * std::numbers::pi) * (angle - std::sin(angle));
}

// --- table --------------------------------------------------------------------------------------

// Between entries 0 and 1 with t = t₀ + s Δ:
//   value = (1−s) y₀ + s y₁ + Δ²/6 [((1−s)³ − (1−s)) y″₀ + (s³ − s) y″₁]

namespace {

/// A table between the entries next − 1 and next.
struct Piece {
  double start, width, low, high, low_curvature, high_curvature;

  Piece(const TableCurve& table, std::size_t next)
      : start(table.time[next - 1]),
        width(table.time[next] - start),
        low(table.values[next - 1]),
        high(table.values[next]),
        low_curvature(table.curvature.empty() ? 0.0 : table.curvature[next - 1]),
        high_curvature(table.curvature.empty() ? 0.0 : table.curvature[next]) {}

  [[nodiscard]] double share(double t) const { return (t - start) / width; }

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

/// The number of entries at or before t.
std::size_t entries_until(const TableCurve& table, double t) {
  const auto after = std::ranges::upper_bound(table.time, t);
  return static_cast<std::size_t>(after - table.time.begin());
}

/// ∫ value from the first entry to t.
double area_until(const TableCurve& table, double t) {
  if (t < table.time.front()) return table.values.front() * (t - table.time.front());
  double sum = 0.0;
  for (std::size_t next = 1; next < table.time.size() && table.time[next - 1] <= t; ++next) {
    const Piece piece(table, next);
    if (piece.width > 0.0) sum += piece.area(std::min(1.0, piece.share(t)));
  }
  return sum + table.values.back() * std::max(0.0, t - table.time.back());
}

}  // namespace

double TableCurve::value(double t) const {
  if (time.empty()) return 0.0;
  const std::size_t next = entries_until(*this, t);
  if (next == 0) return values.front();
  if (next == time.size()) return values.back();
  const Piece piece(*this, next);
  return piece.value(piece.share(t));
}

double TableCurve::rate(double t) const {
  const std::size_t next = entries_until(*this, t);
  if (next == 0 || next == time.size()) return 0.0;
  const Piece piece(*this, next);
  return piece.rate(piece.share(t));
}

double TableCurve::integral(double t) const {
  return time.empty() ? 0.0 : area_until(*this, t) - area_until(*this, 0.0);
}

// --- splines ------------------------------------------------------------------------------------

namespace {

/// Curvatures of a natural spline through the entries [first, last]: elimination of
///   Δ₋ y″₋ + 2 (Δ₋ + Δ₊) y″ + Δ₊ y″₊ = 6 (slope₊ − slope₋),  zero at both ends.
void fit_spline(TableCurve& curve, std::size_t first, std::size_t last) {
  std::vector<double> ratio(last - first + 1, 0.0);  // y″ = y″ so far − ratio y″₊
  const auto width = [&](std::size_t k) { return curve.time[k + 1] - curve.time[k]; };
  const auto slope = [&](std::size_t k) {
    return (curve.values[k + 1] - curve.values[k]) / width(k);
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
  return std::visit([t](const auto& form) { return form.value(t); }, curve);
}

double rate(const Curve& curve, double t) {
  if (t < 0) return 0.0;
  return std::visit([t](const auto& form) { return form.rate(t); }, curve);
}

double integral(const Curve& curve, double t) {
  if (t <= 0) return 0.0;
  return std::visit([t](const auto& form) { return form.integral(t); }, curve);
}

}  // namespace tlsph

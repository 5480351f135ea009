#pragma once
/// \file
/// Load curves: a value over time t [s], zero before t = 0, with the rate and the integral that
/// prescribed motion and exact solutions need.

#include <functional>
#include <string_view>
#include <variant>
#include <vector>

namespace tlsph {

// Every curve has the members value(t), rate(t) and integral(t), for t ≥ 0.

/// amplitude for t ≥ 0.
struct ConstantCurve {
  double amplitude = 0.0;
  [[nodiscard]] double value(double) const { return amplitude; }
  [[nodiscard]] double rate(double) const { return 0.0; }
  [[nodiscard]] double integral(double t) const { return amplitude * t; }
};

/// From 0 at t = 0 linearly to amplitude at t = rise, constant afterwards. `smooth` replaces the
/// line by the C² quintic 10s³ − 15s⁴ + 6s⁵. A rise of 0 is a step.
struct RampCurve {
  double amplitude = 0.0;
  double rise = 0.0;
  bool smooth = false;
  [[nodiscard]] double value(double t) const, rate(double t) const, integral(double t) const;
};

/// The smoothed square pulse A/2 [erf((t − 3r)/r) − erf((t − 3r − T)/r)], r = rise, T = duration.
/// It starts with a step of A erfc(3)/2 = 1.1e-5 A at t = 0. A rise of 0 is the square pulse on [0,
/// T).
struct PulseCurve {
  double amplitude = 0.0;
  double duration = 0.0;
  double rise = 0.0;
  [[nodiscard]] double value(double t) const, rate(double t) const, integral(double t) const;
};

/// amplitude sin²(π t/T) for 0 ≤ t ≤ T, zero afterwards.
struct SineSquaredCurve {
  double amplitude = 0.0;
  double duration = 0.0;
  [[nodiscard]] double value(double t) const, rate(double t) const, integral(double t) const;
};

/// Through (time, value), constant before the first and after the last entry. Times do not
/// decrease; two entries at one time are a jump. As many values as times. Between the entries
/// linear, or cubic with the second derivatives `curvature` at them.
struct TableCurve {
  std::vector<double> time;
  std::vector<double> values;
  std::vector<double> curvature;  ///< empty: linear
  [[nodiscard]] double value(double t) const, rate(double t) const, integral(double t) const;
};

/// The table as natural cubic splines, one between every two jumps: value, rate and second
/// derivative are continuous, and the second derivative is zero at the ends of each. Two entries
/// are joined by a line.
[[nodiscard]] TableCurve cubic_spline(TableCurve table);

/// Functions of t ≥ 0 that a caller supplies. Loads need the value only, moved boundaries the rate
/// too, exact solutions the integral; what is not needed may be left empty.
struct GivenCurve {
  std::function<double(double)> value;
  std::function<double(double)> rate = {};      ///< d(value)/dt
  std::function<double(double)> integral = {};  ///< ∫₀ᵗ value dt'
};

using Curve =
    std::variant<ConstantCurve, RampCurve, PulseCurve, SineSquaredCurve, TableCurve, GivenCurve>;

/// Value at time t.
[[nodiscard]] double value(const Curve& curve, double t);
/// d(value)/dt at time t (right-sided at kinks).
[[nodiscard]] double rate(const Curve& curve, double t);
/// ∫₀ᵗ value dt', zero for t ≤ 0.
[[nodiscard]] double integral(const Curve& curve, double t);

}  // namespace tlsph

#include "tlsph/analysis/oscillation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tlsph/analysis/not_known.hpp"

namespace tlsph {

namespace {

/// The value at sample k, or the summit (the bottom) of the parabola through it and its neighbours.
double vertex(std::span<const double> time, std::span<const double> values, std::size_t k) {
  if (k == 0 || k + 1 == values.size()) return values[k];
  // Newton's form about sample k: q(t) = q_k + (t − t_k)(s + c (t − t_k)).
  const double before = time[k] - time[k - 1];
  const double after = time[k + 1] - time[k];
  const double slope_before = (values[k] - values[k - 1]) / before;
  const double slope_after = (values[k + 1] - values[k]) / after;
  const double curvature = (slope_after - slope_before) / (before + after);
  if (curvature == 0.0) return values[k];  // a plateau
  const double slope = slope_before + curvature * before;
  return values[k] - slope * slope / (4.0 * curvature);
}

}  // namespace

double maximum(std::span<const double> time, std::span<const double> values) {
  assert(!time.empty() && time.size() == values.size());
  return vertex(time, values,
                static_cast<std::size_t>(std::ranges::max_element(values) - values.begin()));
}

double minimum(std::span<const double> time, std::span<const double> values) {
  assert(!time.empty() && time.size() == values.size());
  return vertex(time, values,
                static_cast<std::size_t>(std::ranges::min_element(values) - values.begin()));
}

std::vector<double> passages(std::span<const double> time, std::span<const double> values,
                             double level) {
  assert(time.size() == values.size());
  std::vector<double> times;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double before = values[k - 1] - level;
    const double after = values[k] - level;
    if (before * after < 0.0 || (after == 0.0 && before != 0.0))
      times.push_back(time[k - 1] + (time[k] - time[k - 1]) * before / (before - after));
  }
  return times;
}

double mean_period(std::span<const double> time, std::span<const double> values, double level) {
  constexpr double none = not_known;
  const std::vector<double> at = passages(time, values, level);
  if (at.size() < 3) return none;
  const double middle = 0.5 * static_cast<double>(at.size() - 1);
  double slope = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double from_middle = static_cast<double>(k) - middle;
    slope += from_middle * at[k];
    squares += from_middle * from_middle;
  }
  const double half = slope / squares;
  for (std::size_t k = 1; k < at.size(); ++k)
    if (std::abs(at[k] - at[k - 1] - half) > 0.5 * half) return none;
  return 2.0 * half;
}

}  // namespace tlsph

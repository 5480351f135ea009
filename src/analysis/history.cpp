#include "tlsph/analysis/history.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tlsph/analysis/order.hpp"

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

std::vector<double> resample(std::span<const double> time, std::span<const double> values,
                             std::span<const double> at) {
  assert(!time.empty() && time.size() == values.size());
  const std::size_t n = time.size();
  const std::size_t stencil = std::min<std::size_t>(4, n);
  std::vector<double> result;
  result.reserve(at.size());
  for (const double t : at) {
    if (t <= time.front() || t >= time.back()) {
      result.push_back(t <= time.front() ? values.front() : values.back());
      continue;
    }
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    // Two samples on either side where there are two.
    const std::size_t first = std::min(after > 2 ? after - 2 : 0, n - stencil);
    double sum = 0.0;
    for (std::size_t i = first; i < first + stencil; ++i) {
      double weight = 1.0;  // Lagrange
      for (std::size_t j = first; j < first + stencil; ++j)
        if (j != i) weight *= (t - time[j]) / (time[i] - time[j]);
      sum += weight * values[i];
    }
    result.push_back(sum);
  }
  return result;
}

double squared_norm(std::span<const double> time, std::span<const double> values) {
  assert(time.size() == values.size());
  double sum = 0.0;
  for (std::size_t k = 1; k < time.size(); ++k)
    sum += 0.5 * (time[k] - time[k - 1]) * (values[k] * values[k] + values[k - 1] * values[k - 1]);
  return sum;
}

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
  const std::vector<double> at = passages(time, values, level);
  if (at.size() < 3) return not_known;
  const double middle = 0.5 * static_cast<double>(at.size() - 1);
  double slope = 0.0, squares = 0.0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double from_middle = static_cast<double>(k) - middle;
    slope += from_middle * at[k];
    squares += from_middle * from_middle;
  }
  const double half = slope / squares;
  for (std::size_t k = 1; k < at.size(); ++k)
    if (std::abs(at[k] - at[k - 1] - half) > 0.5 * half) return not_known;
  return 2.0 * half;
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

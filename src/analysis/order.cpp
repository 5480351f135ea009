#include "tlsph/analysis/order.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tlsph {
namespace {

bool usable(double value) {
  return std::isfinite(value) && value > 0.0;
}

/// φ(p) = ln((h^p − g^p)/p) and dφ/dp for h > g. The factor 1/p, common to all differences and
/// swallowed by the constant, keeps φ finite at p = 0.
struct LogDifference {
  double value, slope;
};

LogDifference log_difference(double h, double g, double p) {
  const double L = std::log(h / g);
  if (std::abs(p * L) < 1e-6)
    return {p * std::log(g) + std::log(L) + 0.5 * p * L, std::log(g) + 0.5 * L};
  return {p * std::log(g) + std::log(std::expm1(p * L) / p),
          std::log(g) - L / std::expm1(-p * L) - 1.0 / p};
}

}  // namespace

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
  LineFit line;
  const auto n = static_cast<double>(x.size());
  if (x.size() < 2) return line;
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += x[k] / n;
    mean_y += y[k] / n;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  if (xx == 0.0) return line;
  line.slope = xy / xx;
  line.intercept = mean_y - line.slope * mean_x;
  if (x.size() < 3) return line;
  double residual = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double r = y[k] - line.intercept - line.slope * x[k];
    residual += r * r;
  }
  line.standard_error = std::sqrt(residual / (n - 2.0) / xx);
  return line;
}

std::vector<double> pairwise_orders(std::span<const double> spacing,
                                    std::span<const double> error) {
  assert(spacing.size() == error.size());
  std::vector<double> orders(error.size(), not_known);
  for (std::size_t k = 1; k < error.size(); ++k)
    if (usable(error[k - 1]) && usable(error[k]))
      orders[k] = std::log(error[k - 1] / error[k]) / std::log(spacing[k - 1] / spacing[k]);
  return orders;
}

OrderFit fit_order(std::span<const double> spacing, std::span<const double> error) {
  assert(spacing.size() == error.size());
  std::vector<double> x, y;
  for (std::size_t k = 0; k < error.size(); ++k) {
    if (!usable(error[k])) continue;
    x.push_back(std::log(spacing[k]));
    y.push_back(std::log(error[k]));
  }
  const LineFit line = fit_line(x, y);
  return {line.slope, line.intercept, line.standard_error, static_cast<int>(x.size())};
}

OrderFit fit_order_of_differences(std::span<const double> spacing,
                                  std::span<const double> difference) {
  assert(spacing.size() == difference.size() + 1);
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < difference.size(); ++k)
    if (usable(difference[k])) used.push_back(k);
  OrderFit fit;
  fit.points = static_cast<int>(used.size());
  if (used.size() < 2) return fit;

  // Gauss–Newton in p with the constant eliminated: the residual y − φ(p) is fitted by a line in
  // φ'(p). φ' differs between any two differences and levels off on both sides, so p moves
  // monotonically from far away; a step never exceeds `stride`.
  constexpr double stride = 3.0;
  constexpr double extreme = 50.0;  // no order of anything: the differences do not follow the model
  double p = 2.0;
  std::vector<double> slope(used.size());
  std::vector<double> residual(used.size());
  for (int iteration = 0; iteration < 100; ++iteration) {
    for (std::size_t i = 0; i < used.size(); ++i) {
      const std::size_t k = used[i];
      const LogDifference phi = log_difference(spacing[k], spacing[k + 1], p);
      slope[i] = phi.slope;
      residual[i] = std::log(difference[k]) - phi.value;
    }
    const LineFit line = fit_line(slope, residual);
    if (!std::isfinite(line.slope) || std::abs(p) > extreme) return fit;
    if (std::abs(line.slope) < 1e-12 * std::max(1.0, std::abs(p))) {
      fit.order = p;
      // The residual is ln C + ln|p| up to noise: h^p − g^p was divided by p.
      double mean = 0.0;
      for (const double r : residual) mean += r / static_cast<double>(residual.size());
      fit.log_constant = mean - std::log(std::abs(p));
      fit.standard_error = line.standard_error;
      return fit;
    }
    p += std::clamp(line.slope, -stride, stride);
  }
  return fit;
}

std::vector<double> pairwise_orders_of_differences(std::span<const double> spacing,
                                                   std::span<const double> difference) {
  std::vector<double> orders(spacing.size(), not_known);
  for (std::size_t k = 2; k < spacing.size(); ++k)
    orders[k] =
        fit_order_of_differences(spacing.subspan(k - 2, 3), difference.subspan(k - 2, 2)).order;
  return orders;
}

double richardson_error(double difference, double ratio, double order) {
  assert(ratio > 1.0);
  if (!(order > 0.0)) return not_known;
  return difference / std::expm1(order * std::log(ratio));
}

double richardson_limit(double coarse, double fine, double ratio, double order) {
  return fine + richardson_error(fine - coarse, ratio, order);
}

}  // namespace tlsph

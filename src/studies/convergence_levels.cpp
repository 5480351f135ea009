// What the runs of a series show: how samples scatter, the orders, the limits.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Rows = std::span<const ConvergenceRow>;

/// Rows of one spacing, coarse to fine.
std::vector<Rows> by_level(Rows rows) {
  std::vector<Rows> levels;
  while (!rows.empty()) {
    const auto next = std::ranges::find_if(
        rows, [&](const ConvergenceRow& row) { return row.particles != rows.front().particles; });
    levels.emplace_back(rows.begin(), next);
    rows = {next, rows.end()};
  }
  return levels;
}

/// The middle value, or the mean of the middle two; `values` sorted.
double middle(const std::vector<double>& values) {
  const std::size_t n = values.size();
  if (n == 0) return not_known;
  const double upper = values[n / 2];
  return n % 2 == 1 || upper == infinite ? upper : 0.5 * (values[n / 2 - 1] + upper);
}

/// Orders between the levels that count, and the order through all of them.
struct Orders {
  std::vector<double> between;  ///< one a level
  OrderFit fit;
};

/// Levels without a finite value are passed over, so that a run that failed does not break a
/// series: the orders are those of the rest.
Orders orders_of(const std::vector<ConvergenceLevel>& levels, std::size_t quantity,
                 double Spread::*pick, ConvergenceMethod method) {
  std::vector<double> spacings, errors;
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const ConvergenceLevel& level = levels[k];
    const double error = level.errors[quantity].*pick;
    if (level.failed == level.runs || std::isinf(error)) continue;
    spacings.push_back(level.spacing);
    errors.push_back(error);
    used.push_back(k);
  }
  Orders orders{std::vector<double>(levels.size(), not_known), {}};
  if (used.empty()) return orders;
  std::vector<double> between;
  if (method == ConvergenceMethod::exact) {
    between = pairwise_orders(spacings, errors);
    orders.fit = fit_order(spacings, errors);
  } else {
    errors.pop_back();  // the finest is compared with nothing
    between = pairwise_orders_of_differences(spacings, errors);
    orders.fit = fit_order_of_differences(spacings, errors);
  }
  for (std::size_t k = 0; k < used.size(); ++k) orders.between[used[k]] = between[k];
  return orders;
}

/// Richardson's estimate for the finest level with a run that did not fail.
double finest_error(const std::vector<ConvergenceLevel>& levels, std::size_t quantity,
                    double order) {
  std::vector<const ConvergenceLevel*> used;
  for (const ConvergenceLevel& level : levels)
    if (level.failed < level.runs) used.push_back(&level);
  if (used.size() < 2) return not_known;
  const ConvergenceLevel& coarse = *used[used.size() - 2];
  return richardson_error(coarse.errors[quantity].median, coarse.spacing / used.back()->spacing,
                          order);
}

}  // namespace

Spread spread_of(std::vector<double> errors) {
  std::erase_if(errors, [](double error) { return std::isnan(error); });
  if (errors.empty()) return {};
  std::ranges::sort(errors);
  return {errors.front(), middle(errors), errors.back()};
}

SeriesOrders find_orders(Rows rows, const std::vector<std::string>& quantities,
                         ConvergenceMethod method) {
  SeriesOrders result;
  if (rows.empty()) return result;
  for (const Rows samples : by_level(rows)) {
    ConvergenceLevel level;
    level.series = samples.front().series;
    level.spacing = samples.front().spacing;
    level.particles = samples.front().particles;
    level.runs = static_cast<int>(samples.size());
    level.failed = static_cast<int>(std::ranges::count_if(
        samples, [](const ConvergenceRow& row) { return !row.failure.empty(); }));
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      std::vector<double> errors;
      for (const ConvergenceRow& row : samples)
        errors.push_back(row.failure.empty() ? row.errors[q] : infinite);
      // The finest level of method `probes` has no errors; a failure there is not one either.
      const bool compared = std::ranges::any_of(errors, [](double e) { return std::isfinite(e); });
      level.errors.push_back(compared || level.failed == level.runs ? spread_of(std::move(errors))
                                                                    : Spread{});
    }
    result.levels.push_back(std::move(level));
  }
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const Orders median = orders_of(result.levels, q, &Spread::median, method);
    const Orders worst = orders_of(result.levels, q, &Spread::worst, method);
    ConvergenceFit entry{rows.front().series, quantities[q], median.fit, worst.fit, not_known};
    if (method == ConvergenceMethod::probes)
      entry.finest_error = finest_error(result.levels, q, median.fit.order);
    result.fits.push_back(entry);
    for (std::size_t k = 0; k < result.levels.size(); ++k) {
      result.levels[k].median_orders.push_back(median.between[k]);
      result.levels[k].worst_orders.push_back(worst.between[k]);
    }
  }
  return result;
}

std::vector<ConvergenceValue> find_limits(Rows rows, const std::vector<std::string>& names) {
  std::vector<ConvergenceValue> values;
  if (rows.empty()) return values;
  for (std::size_t v = 0; v < names.size(); ++v) {
    ConvergenceValue value;
    value.series = rows.front().series;
    value.name = names[v];
    for (const Rows samples : by_level(rows)) {
      std::vector<double> read;
      for (const ConvergenceRow& row : samples)
        if (v < row.values.size()) read.push_back(row.values[v]);
      const Spread spread = spread_of(std::move(read));
      if (!std::isfinite(spread.median)) continue;
      value.spacings.push_back(samples.front().spacing);
      value.lowest.push_back(spread.best);
      value.medians.push_back(spread.median);
      value.highest.push_back(spread.worst);
    }
    if (value.medians.size() >= 3) {
      const std::span<const double> h = std::span(value.spacings).last<3>();
      const std::span<const double> f = std::span(value.medians).last<3>();
      if ((f[1] - f[0]) * (f[2] - f[1]) > 0.0) {
        const std::array differences = {std::abs(f[1] - f[0]), std::abs(f[2] - f[1])};
        value.order = fit_order_of_differences(h, differences).order;
        value.limit = richardson_limit(f[1], f[2], h[1] / h[2], value.order);
        value.finest_error = std::abs(f[2] / value.limit - 1.0);
        if (!(value.order > 0.0)) value.order = not_known;
      }
    }
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace tlsph

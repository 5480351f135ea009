// A convergence study on the screen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

std::string method_text(ConvergenceMethod method) {
  return method == ConvergenceMethod::exact
             ? "relative L2 errors against the exact solution at the end\n"
             : "no exact solution: relative L2 differences in time of the probes from the next "
               "finer "
               "run,\norders from three successive runs\n";
}

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string with_error(const OrderFit& fit) {
  std::string order = number(fit.order, "{:.2f}");
  if (std::isfinite(fit.standard_error)) order += fmt::format(" ±{:.2f}", fit.standard_error);
  return order;
}

std::string ended(std::string line) {
  return line.erase(line.find_last_not_of(' ') + 1) + "\n";
}

/// Width of a quantity's value; its order follows in `order_width` more.
std::size_t value_width(const std::string& quantity) {
  return std::max<std::size_t>(quantity.size(), 9);
}
constexpr std::size_t order_width = 7;

/// A series of one run a level: all quantities side by side.
class SingleRuns {
 public:
  SingleRuns(const ConvergenceTable& table, const std::string& series)
      : table_(table), series_(series) {}

  [[nodiscard]] std::string text() const {
    std::string text = header();
    for (const ConvergenceRow& row : table_.rows)
      if (row.series == series_) text += line_of(row);
    return text + footer();
  }

 private:
  [[nodiscard]] std::string header() const {
    std::string text = fmt::format("\n{}\n{:>12} {:>12} {:>10} {:>13}", series_, "spacing [m]",
                                   "particles", "steps", "wall time [s]");
    for (const std::string& quantity : table_.quantities)
      text += fmt::format("  {:>{}}{:>{}}", quantity, value_width(quantity), "order", order_width);
    return text + "\n";
  }

  [[nodiscard]] std::string line_of(const ConvergenceRow& row) const {
    std::string text = fmt::format("{:>12.6g} {:>12} ", row.spacing, row.particles);
    if (!row.failure.empty()) return text + fmt::format("failed: {}\n", row.failure);
    text += fmt::format("{:>10} {:>13.3g}", row.steps, row.wall_seconds);
    for (std::size_t q = 0; q < table_.quantities.size(); ++q)
      text += fmt::format("  {:>{}}{:>{}}", number(row.errors[q], "{:.3e}"),
                          value_width(table_.quantities[q]), number(row.orders[q], "{:.2f}"),
                          order_width);
    return text + "\n";
  }

  /// Fitted orders below their columns, and what they say of the finest run.
  [[nodiscard]] std::string footer() const {
    std::string orders = fmt::format("{:>50}", "fitted order");
    std::string left = fmt::format("{:>50}", "estimated error of the finest run");
    bool any_order = false;
    bool any_left = false;
    for (const ConvergenceFit& entry : table_.fits) {
      if (entry.series != series_) continue;
      const std::size_t width = value_width(entry.quantity);
      orders += fmt::format("  {:>{}}", with_error(entry.fit), width + order_width);
      left += fmt::format("  {:>{}}{:{}}", number(entry.finest_error, "{:.3e}"), width, "",
                          order_width);
      any_order = any_order || std::isfinite(entry.fit.order);
      any_left = any_left || std::isfinite(entry.finest_error);
    }
    return (any_order ? ended(orders) : "") + (any_left ? ended(left) : "");
  }

  const ConvergenceTable& table_;
  const std::string& series_;
};

/// A series of samples: a block a quantity, the median and the worst side by side.
std::string samples_text(const ConvergenceTable& table, const std::string& series) {
  std::string text;
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    text += fmt::format("\n{}: {}\n{:>12} {:>12} {:>8} {:>12}{:>7} {:>12}{:>7} {:>13}\n", series,
                        table.quantities[q], "spacing [m]", "particles", "runs", "median", "order",
                        "worst", "order", "worst/best");
    for (const ConvergenceLevel& level : table.levels) {
      if (level.series != series) continue;
      const Spread& spread = level.errors[q];
      text += fmt::format("{:>12.6g} {:>12} {:>8} {:>12}{:>7} {:>12}{:>7} {:>13}", level.spacing,
                          level.particles, level.runs, number(spread.median, "{:.3e}"),
                          number(level.median_orders[q], "{:.2f}"), number(spread.worst, "{:.3e}"),
                          number(level.worst_orders[q], "{:.2f}"),
                          number(spread.worst / spread.best, "{:.2f}"));
      if (level.failed > 0) text += fmt::format("  {} failed", level.failed);
      text += "\n";
    }
    for (const ConvergenceFit& entry : table.fits) {
      if (entry.series != series || entry.quantity != table.quantities[q]) continue;
      if (std::isfinite(entry.fit.order))
        text += ended(fmt::format("{:>34} {:>19} {:>19}", "fitted order", with_error(entry.fit),
                                  with_error(entry.worst_fit)));
      if (std::isfinite(entry.finest_error))
        text +=
            fmt::format("{:>34} {:>12.3e}\n", "estimated error of the finest", entry.finest_error);
    }
  }
  return text;
}

/// Numbers read off the probes, finest and extrapolated.
std::string values_text(const ConvergenceTable& table, const std::string& series) {
  std::size_t width = 24;
  for (const std::string& name : table.value_names) width = std::max(width, name.size());
  std::string lines;
  for (const ConvergenceValue& value : table.values) {
    if (value.series != series || value.medians.empty()) continue;
    // Beyond what a scheme has: the levels are too coarse to extrapolate from, or round-off.
    const bool doubtful = value.order < 0.5 || value.order > 6.0;
    lines += ended(fmt::format("{:>{}} {:>14.7g} {:>14} {:>7} {:>12}{}", value.name, width,
                               value.medians.back(), number(value.limit, "{:.7g}"),
                               number(value.order, "{:.2f}"), number(value.finest_error, "{:.3e}"),
                               doubtful ? "  doubtful: not the order of a scheme" : ""));
  }
  if (lines.empty()) return "";
  return fmt::format("{:>{}} {:>14} {:>14} {:>7} {:>12}\n", "read off the probes", width, "finest",
                     "extrapolated", "order", "rel. error") +
         lines;
}

}  // namespace

bool ConvergenceTable::sampled() const {
  return std::ranges::any_of(levels, [](const ConvergenceLevel& level) { return level.runs > 1; });
}

std::string ConvergenceTable::text() const {
  std::string text = method_text(method);
  std::vector<std::string> series;
  for (const ConvergenceRow& row : rows)
    if (series.empty() || series.back() != row.series) series.push_back(row.series);
  for (const std::string& one : series) {
    text += sampled() ? samples_text(*this, one) : SingleRuns(*this, one).text();
    text += values_text(*this, one);
  }
  if (interrupted) text += "\ninterrupted: the runs that were done\n";
  return text;
}

}  // namespace tlsph

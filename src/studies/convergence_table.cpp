// A convergence study on the screen and in its files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
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

/// What the study varies beside the spacing are columns with the names of the keys.
Table<ConvergenceRow> run_table(const ConvergenceTable& study) {
  using Row = ConvergenceRow;
  Table<Row> table = {
      {"series", &Row::series, Medium::json},
      {"spacing", &Row::spacing, {"spacing [m]", ">12.6g"}},
      {"particles", &Row::particles, {"particles", " >12"}},
      {"steps", &Row::steps, {"steps", " >10"}},
      {"dt", &Row::dt},
      {"wall_seconds", &Row::wall_seconds, {"wall time [s]", " >13.3g"}},
      {"formulation", &Row::formulation},
  };
  const auto element = [](auto Row::*values, std::size_t k) {
    return [values, k](const Row& row) {
      return k < (row.*values).size() ? Json((row.*values)[k]) : Json(nullptr);
    };
  };
  for (std::size_t k = 0; k < study.over.size(); ++k)
    table.add({study.over[k], element(&Row::over, k), Medium::csv});
  if (!study.sample_key.empty()) {
    table.add({study.sample_key, &Row::sample, Medium::csv});
    table.add({"sample", &Row::sample, Medium::json});
  }
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const std::string& name = study.quantities[q];
    table.add({name, element(&Row::errors, q), {name, fmt::format("  >{}.3e", value_width(name))}});
    table.add({"", element(&Row::orders, q), {"order", fmt::format(">{}.2f", order_width)}});
  }
  for (std::size_t q = 0; q < study.quantities.size(); ++q)
    table.add({"order_" + study.quantities[q], element(&Row::orders, q)});
  for (std::size_t v = 0; v < study.value_names.size(); ++v)
    table.add({study.value_names[v], element(&Row::values, v), Medium::csv});
  table.add({"failure", [](const Row& row) { return Json::text_or_null(row.failure); }});
  return table;
}

Table<ConvergenceLevel> level_table() {
  using Row = ConvergenceLevel;
  return {
      {"series", &Row::series},
      {"spacing", &Row::spacing, {"spacing [m]", ">12.6g"}},
      {"particles", &Row::particles, {"particles", " >12"}},
      {"runs", &Row::runs, {"runs", " >8"}},
      {"failed", &Row::failed},
  };
}

/// A quantity of a level.
struct LevelQuantity : Spread {
  ConvergenceLevel level;
  std::string quantity;
  double median_order, worst_order;
};

std::vector<LevelQuantity> quantities_of(const std::vector<ConvergenceLevel>& levels,
                                         const ConvergenceTable& study) {
  std::vector<LevelQuantity> all;
  for (const ConvergenceLevel& level : levels)
    for (std::size_t q = 0; q < study.quantities.size(); ++q)
      all.push_back({level.errors[q], level, study.quantities[q], level.median_orders[q],
                     level.worst_orders[q]});
  return all;
}

Table<LevelQuantity> spread_table() {
  using Row = LevelQuantity;
  const auto failed = [](const Row& row) {
    return row.level.failed > 0 ? fmt::format("{} failed", row.level.failed) : "";
  };
  return {
      {"quantity", &Row::quantity, Medium::csv},
      {"best", &Row::best},
      {"median", &Row::median, {"median", " >12.3e"}},
      {"", &Row::median_order, {"order", ">7.2f"}},
      {"worst", &Row::worst, {"worst", " >12.3e"}},
      {"", &Row::worst_order, {"order", ">7.2f"}},
      {"order_median", &Row::median_order},
      {"order_worst", &Row::worst_order},
      {"", [](const Row& row) { return row.worst / row.best; }, {"worst/best", " >13.2f"}},
      {"", failed, {"", "  <"}},
  };
}

Table<LevelQuantity> level_quantity_table() {
  return level_table().of(&LevelQuantity::level) + spread_table();
}

std::vector<Json> levels_json(const ConvergenceTable& study) {
  std::vector<Json> levels = level_table().json(study.levels);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const std::vector<Json> spreads = spread_table().json(quantities_of({study.levels[k]}, study));
    for (std::size_t q = 0; q < spreads.size(); ++q) levels[k].set(study.quantities[q], spreads[q]);
  }
  return levels;
}

Table<ConvergenceFit> fit_table(const ConvergenceTable& study) {
  using Row = ConvergenceFit;
  Table<Row> table = {
      {"series", &Row::series},
      {"formulation", [](const Row& row) { return row.series.substr(0, row.series.find(' ')); }},
      {"quantity", &Row::quantity},
      {"order", [](const Row& row) { return row.fit.order; }},
      {"standard_error", [](const Row& row) { return row.fit.standard_error; }},
      {"log_constant", [](const Row& row) { return row.fit.log_constant; }},
      {"points", [](const Row& row) { return row.fit.points; }},
  };
  if (study.sampled()) {
    table.add({"order_worst", [](const Row& row) { return row.worst_fit.order; }});
    table.add(
        {"standard_error_worst", [](const Row& row) { return row.worst_fit.standard_error; }});
  }
  if (study.method == ConvergenceMethod::probes) table.add({"finest_error", &Row::finest_error});
  return table;
}

/// Numbers read off the probes, finest and extrapolated.
Table<ConvergenceValue> value_table(bool sampled) {
  using Row = ConvergenceValue;
  // Beyond what a scheme has: the levels are too coarse to extrapolate from, or round-off.
  const auto remark = [](const Row& row) {
    return row.order < 0.5 || row.order > 6.0 ? "doubtful: not the order of a scheme" : "";
  };
  Table<Row> table = {
      {"series", &Row::series},
      {"name", &Row::name, {"read off the probes", ">24"}},
      {"spacing", &Row::spacings},
      {"value", &Row::medians},
      {"", [](const Row& row) { return row.medians.back(); }, {"finest", " >14.7g"}},
      {"extrapolated", &Row::limit, {"extrapolated", " >14.7g"}},
      {"order", &Row::order, {"order", " >7.2f"}},
      {"finest_error", &Row::finest_error, {"rel. error", " >12.3e"}},
      {"", remark, {"", "  <"}},
  };
  const Table<Row> scatter = {{"lowest", &Row::lowest}, {"highest", &Row::highest}};
  return sampled ? table + scatter : table;
}

template <class Row>
std::vector<Row> of_series(const std::vector<Row>& rows, const std::string& series) {
  std::vector<Row> chosen;
  std::ranges::copy_if(rows, std::back_inserter(chosen),
                       [&](const Row& row) { return row.series == series; });
  return chosen;
}

/// Fitted orders below their columns, and what they say of the finest run.
std::string footer(const std::vector<ConvergenceFit>& fits) {
  std::string orders = fmt::format("{:>50}", "fitted order");
  std::string left = fmt::format("{:>50}", "estimated error of the finest run");
  bool any_order = false;
  bool any_left = false;
  for (const ConvergenceFit& entry : fits) {
    const std::size_t width = value_width(entry.quantity);
    orders += fmt::format("  {:>{}}", with_error(entry.fit), width + order_width);
    left +=
        fmt::format("  {:>{}}{:{}}", number(entry.finest_error, "{:.3e}"), width, "", order_width);
    any_order = any_order || std::isfinite(entry.fit.order);
    any_left = any_left || std::isfinite(entry.finest_error);
  }
  return (any_order ? ended(orders) : "") + (any_left ? ended(left) : "");
}

/// A series of one run a level: all quantities side by side.
std::string runs_text(const ConvergenceTable& study, const std::string& series) {
  const std::vector<ConvergenceRow> rows = of_series(study.rows, series);
  const std::vector<std::string> lines = run_table(study).lines(rows);
  std::string text = fmt::format("\n{}\n{}\n", series, lines[0]);
  for (std::size_t k = 0; k < rows.size(); ++k)
    text += rows[k].failure.empty() ? lines[k + 1] + "\n"
                                    : fmt::format("{:>12.6g} {:>12} failed: {}\n", rows[k].spacing,
                                                  rows[k].particles, rows[k].failure);
  return text + footer(of_series(study.fits, series));
}

/// A series of samples: a block a quantity, the median and the worst side by side.
std::string samples_text(const ConvergenceTable& study, const std::string& series) {
  const auto levels = quantities_of(of_series(study.levels, series), study);
  std::string text;
  for (const std::string& quantity : study.quantities) {
    std::vector<LevelQuantity> rows;
    std::ranges::copy_if(levels, std::back_inserter(rows),
                         [&](const LevelQuantity& row) { return row.quantity == quantity; });
    text += fmt::format("\n{}: {}\n{}", series, quantity, level_quantity_table().text(rows));
    for (const ConvergenceFit& entry : of_series(study.fits, series)) {
      if (entry.quantity != quantity) continue;
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

std::string values_text(const ConvergenceTable& study, const std::string& series) {
  std::vector<ConvergenceValue> values = of_series(study.values, series);
  std::erase_if(values, [](const ConvergenceValue& value) { return value.medians.empty(); });
  return values.empty() ? "" : value_table(study.sampled()).text(values);
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
    text += sampled() ? samples_text(*this, one) : runs_text(*this, one);
    text += values_text(*this, one);
  }
  if (interrupted) text += "\ninterrupted: the runs that were done\n";
  return text;
}

void ConvergenceTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "convergence.csv", run_table(*this).csv(rows));
  if (sampled())
    write_text_file(directory / "spread.csv",
                    level_quantity_table().csv(quantities_of(levels, *this)));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("method", method == ConvergenceMethod::exact ? "exact" : "probes");
  json.set("quantities", quantities);
  json.set("interrupted", interrupted);
  json.set("rows", run_table(*this).json(rows));
  json.set("orders", fit_table(*this).json(fits));
  if (sampled()) json.set("levels", levels_json(*this));
  if (!value_names.empty()) json.set("values", value_table(sampled()).json(values));
  json.write(directory / "convergence.json");
}

}  // namespace tlsph

// A convergence study on the screen and in its files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

std::string method_name(ConvergenceMethod method) {
  return method == ConvergenceMethod::exact ? "exact" : "probes";
}

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

/// A cell of the CSV: 17 digits, nothing where there is no number.
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "";
}

/// Width of a quantity's value; its order follows in `order_width` more.
std::size_t value_width(const std::string& quantity) {
  return std::max<std::size_t>(quantity.size(), 9);
}
constexpr std::size_t order_width = 7;

std::string header(const ConvergenceTable& table, const std::string& formulation) {
  std::string text = fmt::format("\n{}\n{:>12} {:>12} {:>10} {:>13}", formulation, "spacing [m]",
                                 "particles", "steps", "wall time [s]");
  for (const std::string& quantity : table.quantities)
    text += fmt::format("  {:>{}}{:>{}}", quantity, value_width(quantity), "order", order_width);
  return text + "\n";
}

std::string line_of(const ConvergenceRow& row, const std::vector<std::string>& quantities) {
  std::string text = fmt::format("{:>12.6g} {:>12} ", row.spacing, row.particles);
  if (!row.failure.empty()) return text + fmt::format("failed: {}\n", row.failure);
  text += fmt::format("{:>10} {:>13.3g}", row.steps, row.wall_seconds);
  for (std::size_t q = 0; q < quantities.size(); ++q)
    text += fmt::format("  {:>{}}{:>{}}", number(row.errors[q], "{:.3e}"),
                        value_width(quantities[q]), number(row.orders[q], "{:.2f}"), order_width);
  return text + "\n";
}

/// Fitted orders below their columns, and what they say of the finest run.
std::string footer(const ConvergenceTable& table, const std::string& formulation) {
  std::string orders = fmt::format("{:>50}", "fitted order");
  std::string left = fmt::format("{:>50}", "estimated error of the finest run");
  bool any_order = false;
  bool any_left = false;
  for (const ConvergenceFit& entry : table.fits) {
    if (entry.formulation != formulation) continue;
    std::string order = number(entry.fit.order, "{:.2f}");
    if (std::isfinite(entry.fit.standard_error))
      order += fmt::format(" ±{:.2f}", entry.fit.standard_error);
    orders += fmt::format("  {:>{}}", order, value_width(entry.quantity) + order_width);
    left += fmt::format("  {:>{}}{:{}}", number(entry.finest_error, "{:.3e}"),
                        value_width(entry.quantity), "", order_width);
    any_order = any_order || std::isfinite(entry.fit.order);
    any_left = any_left || std::isfinite(entry.finest_error);
  }
  const auto ended = [](std::string line) {
    return line.erase(line.find_last_not_of(' ') + 1) + "\n";
  };
  return (any_order ? ended(orders) : "") + (any_left ? ended(left) : "");
}

std::string csv_text(const ConvergenceTable& table) {
  std::string csv = "spacing,particles,steps,dt,wall_seconds,formulation";
  const auto end = std::back_inserter(csv);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",{}", quantity);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",order_{}", quantity);
  csv.append(",failure\n");
  for (const ConvergenceRow& row : table.rows) {
    fmt::format_to(end, "{:.17g},{},{},{},{},{}", row.spacing, row.particles, row.steps,
                   cell(row.dt), cell(row.wall_seconds), row.formulation);
    for (const double error : row.errors) fmt::format_to(end, ",{}", cell(error));
    for (const double order : row.orders) fmt::format_to(end, ",{}", cell(order));
    fmt::format_to(end, ",{}\n", csv_field(row.failure));
  }
  return csv;
}

Json row_json(const ConvergenceRow& row, const std::vector<std::string>& quantities) {
  Json json;
  json.set("formulation", row.formulation);
  json.set("spacing", row.spacing);
  json.set("particles", row.particles);
  json.set("steps", row.steps);
  json.set("dt", row.dt);
  json.set("wall_seconds", row.wall_seconds);
  for (std::size_t q = 0; q < quantities.size(); ++q) json.set(quantities[q], row.errors[q]);
  for (std::size_t q = 0; q < quantities.size(); ++q)
    json.set("order_" + quantities[q], row.orders[q]);
  if (row.failure.empty())
    json.set("failure", nullptr);
  else
    json.set("failure", row.failure);
  return json;
}

Json fit_json(const ConvergenceFit& entry, ConvergenceMethod method) {
  Json json;
  json.set("formulation", entry.formulation);
  json.set("quantity", entry.quantity);
  json.set("order", entry.fit.order);
  json.set("standard_error", entry.fit.standard_error);
  json.set("log_constant", entry.fit.log_constant);
  json.set("points", entry.fit.points);
  if (method == ConvergenceMethod::probes) json.set("finest_error", entry.finest_error);
  return json;
}

}  // namespace

std::string ConvergenceTable::text() const {
  std::string text = method_text(method);
  std::string formulation;
  for (const ConvergenceRow& row : rows) {
    if (row.formulation != formulation) {
      if (!formulation.empty()) text += footer(*this, formulation);
      formulation = row.formulation;
      text += header(*this, formulation);
    }
    text += line_of(row, quantities);
  }
  if (!formulation.empty()) text += footer(*this, formulation);
  if (interrupted) text += "\ninterrupted: the runs that were done\n";
  return text;
}

void ConvergenceTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "convergence.csv", csv_text(*this));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("method", method_name(method));
  json.set("quantities", quantities);
  json.set("interrupted", interrupted);
  json.make_list("rows");
  for (const ConvergenceRow& row : rows) json.append("rows", row_json(row, quantities));
  json.make_list("orders");
  for (const ConvergenceFit& entry : fits) json.append("orders", fit_json(entry, method));
  json.write(directory / "convergence.json");
}

}  // namespace tlsph

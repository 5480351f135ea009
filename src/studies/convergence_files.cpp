// A convergence study in its files.
#include <fmt/format.h>

#include <iterator>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

/// A row a run; what the study varies beside the spacing are columns with the names of the keys.
std::string runs_csv(const ConvergenceTable& table) {
  std::string csv = "spacing,particles,steps,dt,wall_seconds,formulation";
  const auto end = std::back_inserter(csv);
  for (const std::string& key : table.over) fmt::format_to(end, ",{}", csv_field(key));
  if (!table.sample_key.empty()) fmt::format_to(end, ",{}", table.sample_key);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",{}", quantity);
  for (const std::string& quantity : table.quantities) fmt::format_to(end, ",order_{}", quantity);
  for (const std::string& name : table.value_names) fmt::format_to(end, ",{}", csv_field(name));
  csv.append(",failure\n");
  for (const ConvergenceRow& row : table.rows) {
    fmt::format_to(end, "{:.17g},{},{},{},{},{}", row.spacing, row.particles, row.steps,
                   csv_number(row.dt), csv_number(row.wall_seconds), row.formulation);
    for (const std::string& value : row.over) fmt::format_to(end, ",{}", csv_field(value));
    if (!table.sample_key.empty()) fmt::format_to(end, ",{}", csv_field(row.sample));
    for (const double error : row.errors) fmt::format_to(end, ",{}", csv_number(error));
    for (const double order : row.orders) fmt::format_to(end, ",{}", csv_number(order));
    for (std::size_t v = 0; v < table.value_names.size(); ++v)
      fmt::format_to(end, ",{}", v < row.values.size() ? csv_number(row.values[v]) : "");
    fmt::format_to(end, ",{}\n", csv_field(row.failure));
  }
  return csv;
}

/// A row a level and quantity.
std::string spread_csv(const ConvergenceTable& table) {
  std::string csv =
      "series,spacing,particles,runs,failed,quantity,best,median,worst,order_median,order_worst\n";
  for (const ConvergenceLevel& level : table.levels)
    for (std::size_t q = 0; q < table.quantities.size(); ++q)
      fmt::format_to(std::back_inserter(csv), "{},{:.17g},{},{},{},{},{},{},{},{},{}\n",
                     csv_field(level.series), level.spacing, level.particles, level.runs,
                     level.failed, table.quantities[q], csv_number(level.errors[q].best),
                     csv_number(level.errors[q].median), csv_number(level.errors[q].worst),
                     csv_number(level.median_orders[q]), csv_number(level.worst_orders[q]));
  return csv;
}

Json row_json(const ConvergenceRow& row, const ConvergenceTable& table) {
  Json json;
  json.set("series", row.series);
  json.set("formulation", row.formulation);
  if (!table.sample_key.empty()) json.set("sample", row.sample);
  json.set("spacing", row.spacing);
  json.set("particles", row.particles);
  json.set("steps", row.steps);
  json.set("dt", row.dt);
  json.set("wall_seconds", row.wall_seconds);
  for (std::size_t q = 0; q < table.quantities.size(); ++q)
    json.set(table.quantities[q], row.errors[q]);
  for (std::size_t q = 0; q < table.quantities.size(); ++q)
    json.set("order_" + table.quantities[q], row.orders[q]);
  json.set_or_null("failure", row.failure);
  return json;
}

Json level_json(const ConvergenceLevel& level, const ConvergenceTable& table) {
  Json json;
  json.set("series", level.series);
  json.set("spacing", level.spacing);
  json.set("particles", level.particles);
  json.set("runs", level.runs);
  json.set("failed", level.failed);
  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    const std::string& quantity = table.quantities[q];
    json.set(quantity + ".best", level.errors[q].best);
    json.set(quantity + ".median", level.errors[q].median);
    json.set(quantity + ".worst", level.errors[q].worst);
    json.set(quantity + ".order_median", level.median_orders[q]);
    json.set(quantity + ".order_worst", level.worst_orders[q]);
  }
  return json;
}

Json fit_json(const ConvergenceFit& entry, const ConvergenceTable& table) {
  Json json;
  json.set("series", entry.series);
  json.set("formulation", entry.series.substr(0, entry.series.find(' ')));
  json.set("quantity", entry.quantity);
  json.set("order", entry.fit.order);
  json.set("standard_error", entry.fit.standard_error);
  json.set("log_constant", entry.fit.log_constant);
  json.set("points", entry.fit.points);
  if (table.sampled()) {
    json.set("order_worst", entry.worst_fit.order);
    json.set("standard_error_worst", entry.worst_fit.standard_error);
  }
  if (table.method == ConvergenceMethod::probes) json.set("finest_error", entry.finest_error);
  return json;
}

Json value_json(const ConvergenceValue& value, bool sampled) {
  Json json;
  json.set("series", value.series);
  json.set("name", value.name);
  json.set("spacing", value.spacings);
  json.set("value", value.medians);
  if (sampled) {
    json.set("lowest", value.lowest);
    json.set("highest", value.highest);
  }
  json.set("order", value.order);
  json.set("extrapolated", value.limit);
  json.set("finest_error", value.finest_error);
  return json;
}

}  // namespace

void ConvergenceTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "convergence.csv", runs_csv(*this));
  if (sampled()) write_text_file(directory / "spread.csv", spread_csv(*this));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("method", method == ConvergenceMethod::exact ? "exact" : "probes");
  json.set("quantities", quantities);
  json.set("interrupted", interrupted);
  json.make_list("rows");
  for (const ConvergenceRow& row : rows) json.append("rows", row_json(row, *this));
  json.make_list("orders");
  for (const ConvergenceFit& entry : fits) json.append("orders", fit_json(entry, *this));
  if (sampled()) {
    json.make_list("levels");
    for (const ConvergenceLevel& level : levels) json.append("levels", level_json(level, *this));
  }
  if (!value_names.empty()) {
    json.make_list("values");
    for (const ConvergenceValue& value : values)
      json.append("values", value_json(value, sampled()));
  }
  json.write(directory / "convergence.json");
}

}  // namespace tlsph

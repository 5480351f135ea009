#include "readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tlsph/analysis/history.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

const Place value_option{"--value", 0, 0, ""};
constexpr std::array<std::string_view, 5> words = {"end", "max", "min", "peak", "period"};

/// Column and word of a name.
std::pair<std::string, std::string> split(const std::string& name) {
  const auto dot = name.rfind('.');
  if (dot == std::string::npos) return {name, ""};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

/// The columns of probes.csv.
template <int D>
std::vector<std::string> columns_of(const Scene& scene) {
  std::vector<std::string> columns;
  for (const ProbeScene& probe : scene.probes)
    for (const std::string& name : probe.record)
      for (const std::string& suffix : component_suffixes<D>(quantity_named<D>(name)))
        columns.push_back(fmt::format("{}.{}{}", probe.name, name, suffix));
  return columns;
}

double read_value(const std::string& word, const std::vector<double>& time,
                  const std::vector<double>& values) {
  if (word == "end") return values.back();
  if (word == "max") return maximum(time, values);
  if (word == "min") return minimum(time, values);
  if (word == "peak") return std::max(maximum(time, values), -minimum(time, values));
  return mean_period(time, values);
}

}  // namespace

std::optional<ProbedRun> run_probed(const Scene& scene, RunOptions options, bool with_history) {
  ProbeHistories histories;
  if (with_history) options.histories = &histories;
  Summary summary = run(scene, options);
  if (summary.interrupted) return std::nullopt;
  return ProbedRun{std::move(summary), std::move(histories.computed)};
}

std::vector<std::string> error_field_names() {
  std::vector<std::string> names;
  for (const ErrorField& field : error_fields) names.emplace_back(field.name);
  return names;
}

std::vector<double> errors_of(const Summary& summary) {
  std::vector<double> errors;
  if (summary.errors)
    for (const ErrorField& field : error_fields) errors.push_back((*summary.errors).*field.error);
  return errors;
}

void check_value_names(const std::vector<std::string>& names, const Scene& scene) {
  const std::vector<std::string> columns =
      in_dimension(scene.dimension, [&]<int D>() { return columns_of<D>(scene); });
  for (const std::string& name : names) {
    const auto [column, word] = split(name);
    if (std::ranges::find(words, word) == words.end())
      throw InputError(value_option,
                       fmt::format("{}: a value is a column of probes.csv with .{} behind it, e.g. "
                                   "tip.displacement_y.period",
                                   name, fmt::join(words, ", .")));
    if (std::ranges::find(columns, column) == columns.end())
      throw InputError(
          value_option,
          fmt::format("{}: no probe records {}; choose from {}", name, column,
                      columns.empty() ? "none" : fmt::format("{}", fmt::join(columns, ", "))));
  }
}

std::vector<double> read_values(const std::vector<std::string>& names, const History& history) {
  std::vector<double> values;
  for (const std::string& name : names) {
    const auto [column, word] = split(name);
    const auto found = std::ranges::find(history.names, column);
    if (found == history.names.end())
      throw InputError(value_option, fmt::format("{}: the probes have no {}", name, column));
    const auto k = static_cast<std::size_t>(found - history.names.begin());
    values.push_back(read_value(word, history.time, history.values[k]));
  }
  return values;
}

std::vector<std::string> telling_values(const History& history) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < history.names.size(); ++k) {
    const std::vector<double>& values = history.values[k];
    if (std::ranges::all_of(values, [](double value) { return value == 0.0; })) continue;
    names.push_back(history.names[k] + ".peak");
    if (std::isfinite(mean_period(history.time, values)))
      names.push_back(history.names[k] + ".period");
  }
  return names;
}

}  // namespace tlsph

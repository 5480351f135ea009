#include "readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/csv.hpp"
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

/// Whether `column`, "<probe>.<quantity>_<component>", belongs to the quantity.
bool belongs_to(const std::string& column, const std::string& quantity) {
  const std::string stem = column.substr(column.rfind('.') + 1);
  return stem == quantity || stem.starts_with(quantity + "_");
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

std::vector<std::string> recorded_quantities(const Scene& scene) {
  std::vector<std::string> names;
  for (const ProbeScene& probe : scene.probes)
    for (const std::string& name : probe.record)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

std::vector<std::vector<double>> probe_differences(const std::vector<std::string>& quantities,
                                                   const std::vector<History>& histories) {
  if (histories.empty()) return std::vector<std::vector<double>>(quantities.size());
  const History& finest = histories.back();
  const std::size_t runs = histories.size();
  std::vector<std::vector<double>> squares(quantities.size(), std::vector<double>(runs - 1, 0.0));
  std::vector<double> scale(quantities.size(), 0.0);
  for (std::size_t column = 0; column < finest.names.size(); ++column)
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      if (!belongs_to(finest.names[column], quantities[q])) continue;
      scale[q] += squared_norm(finest.time, finest.values[column]);
      std::vector<double> finer = finest.values[column];
      for (std::size_t k = runs - 1; k-- > 0;) {
        std::vector<double> coarse =
            resample(histories[k].time, histories[k].values[column], finest.time);
        for (std::size_t i = 0; i < finer.size(); ++i) finer[i] -= coarse[i];
        squares[q][k] += squared_norm(finest.time, finer);
        finer = std::move(coarse);
      }
    }
  for (std::size_t q = 0; q < quantities.size(); ++q)
    for (double& square : squares[q])
      square = scale[q] > 0.0 ? std::sqrt(square / scale[q]) : not_known;
  return squares;
}

History extrapolated(const History& coarse, const History& fine, double ratio,
                     const std::vector<std::string>& quantities,
                     const std::vector<double>& orders) {
  History limit;
  limit.time = fine.time;
  for (std::size_t column = 0; column < fine.names.size(); ++column)
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      if (!belongs_to(fine.names[column], quantities[q]) || !(orders[q] > 0.0)) continue;
      const std::vector<double> coarser = resample(coarse.time, coarse.values[column], fine.time);
      limit.names.push_back(fine.names[column]);
      limit.values.push_back(fine.values[column]);
      for (std::size_t k = 0; k < coarser.size(); ++k)
        limit.values.back()[k] =
            richardson_limit(coarser[k], fine.values[column][k], ratio, orders[q]);
    }
  return limit;
}

void write_columns(const std::filesystem::path& file, const std::vector<std::string>& names,
                   const std::vector<std::vector<double>>& columns) {
  CsvWriter csv(file, names);
  std::vector<double> row(columns.size());
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c) row[c] = columns[c].at(k);
    csv.row(row);
  }
  csv.close();
}

void write_history(const std::filesystem::path& file, const History& history) {
  std::vector<std::string> names = {"time"};
  std::vector<std::vector<double>> columns = {history.time};
  std::ranges::copy(history.names, std::back_inserter(names));
  std::ranges::copy(history.values, std::back_inserter(columns));
  write_columns(file, names, columns);
}

}  // namespace tlsph

#include "probe_differences.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/io/csv.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

/// Whether `column`, "<probe>.<quantity>_<component>", belongs to the quantity.
bool belongs_to(const std::string& column, const std::string& quantity) {
  const std::string stem = column.substr(column.rfind('.') + 1);
  return stem == quantity || stem.starts_with(quantity + "_");
}

}  // namespace

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

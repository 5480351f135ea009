#include "extrapolated_history.hpp"

#include "probe_differences.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/io/csv.hpp"

namespace tlsph {

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

void write_history(const std::filesystem::path& file, const History& history) {
  std::vector<std::string> columns = {"time"};
  columns.insert(columns.end(), history.names.begin(), history.names.end());
  CsvWriter csv(file, columns);
  std::vector<double> row(columns.size());
  for (std::size_t k = 0; k < history.time.size(); ++k) {
    row[0] = history.time[k];
    for (std::size_t column = 0; column < history.names.size(); ++column)
      row[column + 1] = history.values[column][k];
    csv.row(std::span<const double>(row));
  }
  csv.close();
}

}  // namespace tlsph

#pragma once
/// \file
/// Histories: columns of numbers over time, as probes.csv holds them.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tlsph {

struct History {
  std::vector<double> time;  ///< [s], increasing
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;  ///< by name, one an instant

  History() = default;
  explicit History(std::vector<std::string> columns)
      : names(std::move(columns)), values(names.size()) {}
  /// The values of one more instant, in the order of the names.
  void add(double instant, std::span<const double> row) {
    time.push_back(instant);
    for (std::size_t k = 0; k < row.size(); ++k) values[k].push_back(row[k]);
  }
};

/// What the probes of a run recorded, and the exact solution at the same instants.
struct ProbeHistories {
  History computed;
  History exact;  ///< of the quantities that it knows; without names if there is none
};

}  // namespace tlsph

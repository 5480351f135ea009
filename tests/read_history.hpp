#pragma once
/// \file
/// Reads a table whose first column is `time`, as probes.csv, for tests of the files.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tlsph/observe/history.hpp"

namespace tlsph::test {

inline History read_history(const std::filesystem::path& csv) {
  std::ifstream file(csv);
  std::string line, cell;
  std::getline(file, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
  History history({names.begin() + 1, names.end()});
  while (std::getline(file, line)) {
    std::vector<double> row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');)
      row.push_back(std::stod(cell));
    history.add(row.front(), std::span(row).subspan(1));
  }
  return history;
}

}  // namespace tlsph::test

#include "tlsph/analysis/history.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <fstream>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

double number(std::string_view cell, const Place& place) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw InputError(place, "\"" + std::string(cell) + "\" is no number");
  return value;
}

}  // namespace

History read_history(const std::filesystem::path& csv) {
  Place place{csv.string(), 0, 0, ""};
  std::ifstream file(csv);
  std::string line;
  if (!file || !std::getline(file, line)) throw InputError(place, "cannot be read, or is empty");
  const auto header = cells_of(line);
  place.line = place.column = 1;
  if (header.front() != "time") throw InputError(place, "the first column must be time");
  History history;
  history.names.assign(header.begin() + 1, header.end());
  history.values.resize(history.names.size());
  while (std::getline(file, line)) {
    ++place.line;
    const auto cells = cells_of(line);
    if (cells.size() != history.names.size() + 1)
      throw InputError(place, "a row has as many cells as the header");
    history.time.push_back(number(cells.front(), place));
    for (std::size_t k = 1; k < cells.size(); ++k)
      history.values[k - 1].push_back(number(cells[k], place));
  }
  if (history.time.empty()) throw InputError(place, "no rows");
  return history;
}

std::vector<double> resample(std::span<const double> time, std::span<const double> values,
                             std::span<const double> at) {
  assert(!time.empty() && time.size() == values.size());
  const std::size_t n = time.size();
  const std::size_t stencil = std::min<std::size_t>(4, n);
  std::vector<double> result;
  result.reserve(at.size());
  for (const double t : at) {
    if (t <= time.front() || t >= time.back()) {
      result.push_back(t <= time.front() ? values.front() : values.back());
      continue;
    }
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    // Two samples on either side where there are two.
    const std::size_t first = std::min(after > 2 ? after - 2 : 0, n - stencil);
    double sum = 0.0;
    for (std::size_t i = first; i < first + stencil; ++i) {
      double weight = 1.0;  // Lagrange
      for (std::size_t j = first; j < first + stencil; ++j)
        if (j != i) weight *= (t - time[j]) / (time[i] - time[j]);
      sum += weight * values[i];
    }
    result.push_back(sum);
  }
  return result;
}

double squared_norm(std::span<const double> time, std::span<const double> values) {
  assert(time.size() == values.size());
  double sum = 0.0;
  for (std::size_t k = 1; k < time.size(); ++k)
    sum += 0.5 * (time[k] - time[k - 1]) * (values[k] * values[k] + values[k - 1] * values[k - 1]);
  return sum;
}

}  // namespace tlsph

#include "tlsph/io/points_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "tlsph/core/text.hpp"

namespace tlsph {
namespace fs = std::filesystem;
namespace {

struct Cell {
  std::string_view text;
  int column = 1;  // of the line, from 1
};

std::string_view trimmed(std::string_view text) {
  constexpr const char* blank = " \t\r";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  text = text.substr(first, text.find_last_not_of(blank) - first + 1);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text;
}

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    const std::string_view raw = line.substr(begin, comma - begin);
    const std::size_t blanks = std::min(raw.find_first_not_of(" \t"), raw.size());
    cells.push_back({trimmed(raw), static_cast<int>(begin + blanks) + 1});
    if (comma == line.size()) return cells;
    begin = comma + 1;
  }
}

/// Which cell of a row is what.
struct Columns {
  std::size_t count = 0;
  std::vector<std::size_t> position;  // by axis
  std::optional<std::size_t> volume, tag;
};

Columns read_header(const std::vector<Cell>& header, std::size_t dimension, const Place& place) {
  std::vector<std::string> allowed = {"x", "y", "volume", "tag"};
  if (dimension == 1) allowed.erase(allowed.begin() + 1);
  const std::string choices = fmt::format("{}", fmt::join(allowed, ", "));
  Columns columns{header.size(), {}, {}, {}};
  std::vector<std::optional<std::size_t>> found(allowed.size());
  for (std::size_t k = 0; k < header.size(); ++k) {
    const Place here{place.file, place.line, header[k].column, ""};
    const auto name = std::find(allowed.begin(), allowed.end(), header[k].text);
    if (name == allowed.end())
      throw InputError(here,
                       fmt::format("unknown column \"{}\"; allowed: {}", header[k].text, choices));
    auto& entry = found[static_cast<std::size_t>(name - allowed.begin())];
    if (entry)
      throw InputError(here, fmt::format("the column \"{}\" is there twice", header[k].text));
    entry = k;
  }
  for (std::size_t a = 0; a < dimension; ++a) {
    if (!found[a])
      throw InputError(place, fmt::format("the column \"{}\" is missing; the first line names the "
                                          "columns: {}",
                                          allowed[a], choices));
    columns.position.push_back(*found[a]);
  }
  columns.volume = found[dimension];
  columns.tag = found[dimension + 1];
  return columns;
}

double read_number(const Cell& cell, Place place) {
  place.column = cell.column;
  const char* begin = cell.text.data();
  const char* end = begin + cell.text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (begin == end || error != std::errc() || stop != end || !std::isfinite(value))
    throw InputError(place, fmt::format("\"{}\" is no finite number", cell.text));
  return value;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view word : split(text, ' '))
    if (!word.empty()) words.emplace_back(word);
  return words;
}

}  // namespace

PointsTable PointsTable::in_order(const std::vector<int>& order) const {
  PointsTable result;
  result.file = file;
  result.dimension = dimension;
  for (const int point : order) {
    const auto q = static_cast<std::size_t>(point);
    for (std::size_t a = 0; a < dimension; ++a) result.X.push_back(X[q * dimension + a]);
    if (!V.empty()) result.V.push_back(V[q]);
    if (!tags.empty()) result.tags.push_back(tags[q]);
    result.line.push_back(line[q]);
  }
  return result;
}

PointsTable read_points(const fs::path& file, std::size_t dimension) {
  Place place{file.string(), 0, 0, ""};
  std::error_code error;
  const auto status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) throw InputError(place, "no such file");
  if (status.type() != fs::file_type::regular)
    throw InputError(place, "no file of points, which has a header line and a line per point");
  std::ifstream stream(file);
  if (!stream) throw InputError(place, "cannot be read; check its permissions");

  PointsTable table;
  table.file = file;
  table.dimension = dimension;
  std::optional<Columns> columns;
  std::string text;
  place.column = 1;
  for (place.line = 1; std::getline(stream, text); ++place.line) {
    std::string_view line = text;
    if (place.line == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const std::vector<Cell> cells = cells_of(line);
    if (!columns) {
      columns = read_header(cells, dimension, place);
      continue;
    }
    if (cells.size() != columns->count)
      throw InputError(
          place, fmt::format("{} cells where the header has {}", cells.size(), columns->count));
    for (const std::size_t k : columns->position) table.X.push_back(read_number(cells[k], place));
    if (columns->volume) table.V.push_back(read_number(cells[*columns->volume], place));
    if (columns->tag) table.tags.push_back(words_of(cells[*columns->tag].text));
    table.line.push_back(place.line);
  }
  place.line = 1;
  if (!columns) throw InputError(place, "empty; the first line must name the columns");
  if (table.size() == 0) throw InputError(place, "no points below the header");
  return table;
}

}  // namespace tlsph

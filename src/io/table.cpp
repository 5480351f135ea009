#include "tlsph/io/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <variant>

#include "tlsph/io/csv.hpp"

namespace tlsph {
namespace {

using Texts = std::vector<std::string>;

/// A Screen::layout in its parts.
struct Layout {
  std::string gap;
  char align = '<';
  std::size_t width = 0;
  std::string format;

  explicit Layout(const std::string& text) {
    const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size() - 1);
    char* rest = nullptr;
    gap = text.substr(0, blanks);
    align = text[blanks];
    width = std::strtoul(text.c_str() + blanks + 1, &rest, 10);
    format = rest;
  }
};

/// Columns of a terminal that a text takes: its code points.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// A cell as text; `number` writes bools, integers and doubles.
std::string text_of(const Json& cell, const std::string& missing, const auto& number) {
  const auto write = [&](const auto& value) -> std::string {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::monostate>)
      return missing;
    else if constexpr (std::is_same_v<Value, std::string>)
      return value;
    else
      return number(value);
  };
  return std::visit(write, cell.scalar());
}

std::string csv_of(const Json& cell) {
  return text_of(cell, "", [](auto value) {
    return std::is_same_v<decltype(value), double> ? csv_number(static_cast<double>(value))
                                                   : std::to_string(value);
  });
}

std::string screen_of(const Json& cell, const Screen& screen) {
  if (screen.words != nullptr)
    return text_of(cell, screen.words(std::numeric_limits<double>::quiet_NaN()),
                   [&](auto value) { return screen.words(static_cast<double>(value)); });
  const std::string format = "{:" + Layout(screen.layout).format + "}";
  return text_of(cell, "-", [&](auto value) { return fmt::format(fmt::runtime(format), value); });
}

/// Headings, then the cells as the screen shows them.
std::vector<Texts> shown(const TableCells& cells) {
  std::vector<Texts> lines(cells.rows.size() + 1);
  for (std::size_t c = 0; c < cells.screens.size(); ++c) {
    lines[0].push_back(cells.screens[c].heading);
    for (std::size_t k = 0; k < cells.rows.size(); ++k)
      lines[k + 1].push_back(screen_of(cells.rows[k][c], cells.screens[c]));
  }
  return lines;
}

/// In a table of Markdown a vertical bar would end the cell.
std::string markdown_line(const Texts& texts) {
  std::string line = "|";
  for (const std::string& text : texts) {
    line += ' ';
    for (const char c : text) line.append(c == '|' ? "\\" : "") += c;
    line += " |";
  }
  return line + '\n';
}

}  // namespace

std::string TableCells::csv() const {
  std::string text = csv_line(names);
  for (const std::vector<Json>& row : rows) {
    Texts fields;
    for (const Json& cell : row) fields.push_back(csv_of(cell));
    text += csv_line(fields);
  }
  return text;
}

std::vector<Json> TableCells::json() const {
  std::vector<Json> objects(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t c = 0; c < names.size(); ++c) objects[k].set(names[c], rows[k][c]);
  return objects;
}

std::vector<std::string> TableCells::lines() const {
  const std::vector<Texts> texts = shown(*this);
  std::vector<std::string> lines(texts.size());
  for (std::size_t c = 0; c < screens.size(); ++c) {
    Layout layout(screens[c].layout);
    for (const Texts& line : texts) layout.width = std::max(layout.width, width_of(line[c]));
    for (std::size_t k = 0; k < texts.size(); ++k) {
      const std::string fill(layout.width - width_of(texts[k][c]), ' ');
      lines[k] += layout.gap + (layout.align == '>' ? fill + texts[k][c] : texts[k][c] + fill);
    }
  }
  for (std::string& line : lines) line.erase(line.find_last_not_of(' ') + 1);
  return lines;
}

std::string TableCells::text() const {
  std::string text;
  for (const std::string& line : lines()) text += line + '\n';
  return text;
}

std::string TableCells::markdown() const {
  std::vector<Texts> texts = shown(*this);
  std::string text = markdown_line(texts[0]) + '|';
  for (const Screen& screen : screens)
    text += Layout(screen.layout).align == '>' ? "---:|" : "---|";
  text += '\n';
  for (std::size_t k = 1; k < texts.size(); ++k) text += markdown_line(texts[k]);
  return text;
}

}  // namespace tlsph

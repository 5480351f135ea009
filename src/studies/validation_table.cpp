// The verdicts on the screen, as a page and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "checks_file.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {
namespace {

/// Four digits: 0.01234, 5801, 1.234e-05; `-` where there is no number.
std::string number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value);
}

/// Reports and limits far below what they are held against say no more than their size.
std::string observed_of(const Check& check) {
  const bool round_off = std::abs(check.observed) < 1e-7 && check.observed != 0.0;
  return round_off ? fmt::format("{:.0e}", check.observed) : number(check.observed);
}

std::string reference_of(const Check& check) {
  switch (check.criterion) {
    case Criterion::at_most:
      return "≤ " + number(check.reference);
    case Criterion::at_least:
      return "≥ " + number(check.reference);
    default:
      return number(check.reference);
  }
}

std::string tolerance_of(const Check& check) {
  switch (check.criterion) {
    case Criterion::relative:
      return fmt::format("{:.3g} %", 100.0 * check.tolerance);
    case Criterion::absolute:
      return fmt::format("± {:.3g}", check.tolerance);
    default:
      return "";
  }
}

std::string verdict_of(const Check& check) {
  if (check.criterion == Criterion::reported) return check.holds() ? "(reported)" : "FAILS";
  return check.holds() ? "holds" : "FAILS";
}

using Line = std::array<std::string, 7>;
const Line heads = {"case", "source", "quantity", "reference", "observed", "tolerance", "verdict"};

std::vector<Line> lines_of(const ValidationTable& table) {
  std::vector<Line> lines;
  for (const CaseResult& result : table.cases) {
    for (const Check& check : result.checks)
      lines.push_back({result.name, check.source, check.quantity, reference_of(check),
                       observed_of(check), tolerance_of(check), verdict_of(check)});
    if (!result.failure.empty())
      lines.push_back({result.name, "", result.failure, "", "", "", "FAILS"});
  }
  return lines;
}

/// Columns of a terminal that a text takes: its code points.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string aligned(const Line& line, const std::array<std::size_t, 7>& widths) {
  std::string text;
  for (std::size_t c = 0; c < line.size(); ++c) {
    const std::string gap(widths[c] - width_of(line[c]), ' ');
    const bool right = c == 3 || c == 4;
    text += fmt::format("{}{}", c == 0 ? "" : "  ", right ? gap + line[c] : line[c] + gap);
  }
  return text.erase(text.find_last_not_of(' ') + 1) + "\n";
}

std::string verdict(const ValidationTable& table) {
  std::size_t checks = 0;
  std::size_t reported = 0;
  std::size_t missed = 0;
  std::size_t ended = 0;
  for (const CaseResult& result : table.cases) {
    ended += result.failure.empty() ? 1 : 0;
    for (const Check& check : result.checks) {
      const bool judged = check.criterion != Criterion::reported;
      checks += judged ? 1 : 0;
      reported += judged ? 0 : 1;
      missed += judged && !check.holds() ? 1 : 0;
    }
  }
  std::string text =
      fmt::format("{} cases, {} checks, {} hold", table.cases.size(), checks, checks - missed);
  if (reported > 0) text += fmt::format("; {} more numbers reported", reported);
  if (ended < table.cases.size())
    text += fmt::format("; {} cases came to no end", table.cases.size() - ended);
  return text + (table.interrupted ? "; interrupted\n" : "\n");
}

/// A vertical bar would end the cell of a markdown table.
std::string escaped(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

std::string row(const Line& line) {
  std::string text = "|";
  for (const std::string& cell : line) text += fmt::format(" {} |", escaped(cell));
  return text + "\n";
}

}  // namespace

bool CaseResult::holds() const {
  return failure.empty() && !checks.empty() && std::ranges::all_of(checks, &Check::holds);
}

bool ValidationTable::holds() const {
  return !interrupted && !cases.empty() && std::ranges::all_of(cases, &CaseResult::holds);
}

std::string ValidationTable::text() const {
  const auto lines = lines_of(*this);
  std::array<std::size_t, 7> widths{};
  for (std::size_t c = 0; c < widths.size(); ++c) {
    widths[c] = width_of(heads[c]);
    for (const Line& line : lines) widths[c] = std::max(widths[c], width_of(line[c]));
  }
  std::string text = aligned(heads, widths);
  std::string last;
  for (const Line& line : lines) {
    if (line[0] != last) text += "\n";
    last = line[0];
    text += aligned(line, widths);
  }
  return text + "\n" + verdict(*this);
}

std::string ValidationTable::markdown() const {
  std::string text =
      "# Validation\n\n"
      "Problems of the literature: what must come out, and what does. This page is what\n\n"
      "    ./tlsph validate\n\n"
      "writes as `out/validation/validation.md`. A folder a case explains the problem and what its "
      "source claims;\n[plotting](plotting) says how the figures are drawn. Numbers that are "
      "reported without a verdict are what a\nsource's own method does, beside what the source "
      "says of it.\n\n" +
      verdict(*this) + "\n" + row(heads) + "|---|---|---|---:|---:|---|---|\n";
  std::string last;
  for (Line line : lines_of(*this)) {
    const bool again = line[0] == last;
    last = line[0];
    line[0] = again ? "" : fmt::format("[{0}]({0})", line[0]);
    text += row(line);
  }
  for (const CaseResult& result : cases)
    if (!result.file.empty())
      text += fmt::format("\n## {0}: {1}\n\n![{1}](figures/{2})\n", result.name, result.title,
                          result.file.filename().string());
  return text;
}

void ValidationTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "validation.md", markdown());
  Json json;
  json.set("version", version);
  json.set("holds", holds());
  json.set("interrupted", interrupted);
  json.make_list("cases");
  for (const CaseResult& result : cases) json.append("cases", checks_json(result));
  json.write(directory / "validation.json");
}

}  // namespace tlsph

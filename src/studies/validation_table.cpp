// The verdicts on the screen, as a page and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {
namespace {

constexpr std::array<std::pair<std::string_view, Criterion>, 5> criteria = {
    {{"relative", Criterion::relative},
     {"absolute", Criterion::absolute},
     {"at most", Criterion::at_most},
     {"at least", Criterion::at_least},
     {"reported", Criterion::reported}}};

/// JSON has no NaN; null stands for it.
double number_or_nan(const Json& json, std::string_view path) {
  return json.is_null(path) ? not_known : json.number(path);
}

Check read_check(const Json& json) {
  Check check;
  check.source = json.text("source");
  check.quantity = json.text("quantity");
  const std::string word = json.text("criterion");
  for (const auto& [name, criterion] : criteria)
    if (name == word) check.criterion = criterion;
  check.reference = number_or_nan(json, "reference");
  check.observed = number_or_nan(json, "observed");
  check.tolerance = json.number("tolerance");
  return check;
}

std::string_view name_of(Criterion wanted) {
  return std::ranges::find(criteria, wanted, [](const auto& each) { return each.second; })->first;
}

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

Table<Check> check_table() {
  return {
      {"source", &Check::source, {"source", "  <"}},
      {"quantity", &Check::quantity, {"quantity", "  <"}},
      {"criterion", [](const Check& check) { return name_of(check.criterion); }},
      {"reference", &Check::reference},
      {"", reference_of, {"reference", "  >"}},
      {"observed", &Check::observed},
      {"", observed_of, {"observed", "  >"}},
      {"tolerance", &Check::tolerance},
      {"", tolerance_of, {"tolerance", "  <"}},
      {"holds", &Check::holds},
      {"", verdict_of, {"verdict", "  <"}},
  };
}

/// A check on the screen, below the name of its case.
struct Line {
  std::string name;
  Check check;
};

Table<Line> line_table() {
  return Table<Line>{{"", &Line::name, {"case", "<"}}} + check_table().of(&Line::check);
}

/// A case that failed before its end has a line with the reason.
std::vector<Line> lines_of(const ValidationTable& table) {
  std::vector<Line> lines;
  for (const CaseResult& result : table.cases) {
    for (const Check& check : result.checks) lines.push_back({result.name, check});
    if (!result.failure.empty())
      lines.push_back(
          {result.name, {"", result.failure, Criterion::reported, not_known, not_known, 0.0}});
  }
  return lines;
}

std::string verdict(const ValidationTable& table) {
  std::size_t checks = 0, reported = 0, missed = 0, ended = 0;
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

}  // namespace

Json CaseResult::json() const {
  using Row = CaseResult;
  static const Table<Row> table = {
      {"case", &Row::name},
      {"title", &Row::title},
      {"holds", &Row::holds},
      {"seconds", &Row::seconds},
      {"figure", [](const Row& row) { return row.file.string(); }},
      {"undrawn", &Row::undrawn},
      {"failure", &Row::failure},
      {"checks", [](const Row& row) { return check_table().json(row.checks); }},
  };
  return table.json({*this}).front();
}

CaseResult CaseResult::read(const Json& json) {
  CaseResult result;
  result.name = json.text("case");
  result.title = json.text("title");
  result.seconds = json.number("seconds");
  result.file = json.text("figure");
  result.undrawn = json.text("undrawn");
  result.failure = json.text("failure");
  for (const Json& row : json.list("checks")) result.checks.push_back(read_check(row));
  return result;
}

bool CaseResult::holds() const {
  return failure.empty() && !checks.empty() && std::ranges::all_of(checks, &Check::holds);
}

bool ValidationTable::holds() const {
  return !interrupted && !cases.empty() && std::ranges::all_of(cases, &CaseResult::holds);
}

std::string ValidationTable::text() const {
  const std::vector<Line> lines = lines_of(*this);
  const std::vector<std::string> texts = line_table().lines(lines);
  std::string text = texts[0] + "\n";
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (k == 0 || lines[k].name != lines[k - 1].name) text += "\n";
    text += texts[k + 1] + "\n";
  }
  return text + "\n" + verdict(*this);
}

std::string ValidationTable::markdown() const {
  std::vector<Line> lines = lines_of(*this);
  std::string last;
  for (Line& line : lines) {
    const bool again = line.name == last;
    last = line.name;
    line.name = again ? "" : fmt::format("[{0}]({0})", last);
  }
  std::string text =
      "# Validation\n\n"
      "Problems of the literature: what must come out, and what does. This page is what\n\n"
      "    ./tlsph validate\n\n"
      "writes as `out/validation/validation.md`. A folder a case explains the problem and what its "
      "source claims;\n[plotting](plotting) says how the figures are drawn. Numbers that are "
      "reported without a verdict are what a\nsource's own method does, beside what the source "
      "says of it.\n\n" +
      verdict(*this) + "\n" + line_table().markdown(lines);
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
  std::vector<Json> results;
  for (const CaseResult& result : cases) results.push_back(result.json());
  json.set("cases", results);
  json.write(directory / "validation.json");
}

}  // namespace tlsph

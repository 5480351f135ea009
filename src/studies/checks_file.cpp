#include "checks_file.hpp"

#include <array>
#include <limits>
#include <utility>

#include "tlsph/core/error.hpp"

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
  return json.is_null(path) ? std::numeric_limits<double>::quiet_NaN() : json.number(path);
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

}  // namespace

Json checks_json(const CaseResult& result) {
  Json json;
  json.set("case", result.name);
  json.set("title", result.title);
  json.set("holds", result.holds());
  json.set("seconds", result.seconds);
  json.set("figure", result.file.string());
  json.set("undrawn", result.undrawn);
  json.set("failure", result.failure);
  json.make_list("checks");
  for (const Check& check : result.checks) {
    Json row;
    row.set("source", check.source);
    row.set("quantity", check.quantity);
    for (const auto& [name, criterion] : criteria)
      if (criterion == check.criterion) row.set("criterion", name);
    row.set("reference", check.reference);
    row.set("observed", check.observed);
    row.set("tolerance", check.tolerance);
    row.set("holds", check.holds());
    json.append("checks", row);
  }
  return json;
}

CaseResult read_checks(const Json& json) {
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

}  // namespace tlsph

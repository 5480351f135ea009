#include "failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "evidence.hpp"
#include "words.hpp"

namespace tlsph {
namespace {

using Rows = std::vector<const AtlasRow*>;

std::string plural(const std::set<double>& values, const char* name) {
  if (values.size() == 1) return fmt::format("{} {}", name, *values.begin());
  return fmt::format("{} {} to {}", name, *values.begin(), *values.rbegin());
}

/// Methods, layouts and parameters of the rows.
std::string extent_of_states(const Rows& rows) {
  std::vector<std::string> methods;
  std::set<double> jitter, poisson, stretches;
  std::set<std::string> bodies;
  for (const AtlasRow* row : rows) {
    if (std::ranges::find(methods, row->method) == methods.end()) methods.push_back(row->method);
    jitter.insert(row->jitter);
    poisson.insert(row->poisson);
    stretches.insert(row->stretch);
    bodies.insert(row->body);
  }
  std::string text = methods.size() > 6 ? fmt::format("{} methods", methods.size())
                                        : fmt::format("{}", fmt::join(methods, ", "));
  if (bodies.size() == 1 && *bodies.begin() != "scene") text += ", " + *bodies.begin();
  return fmt::format("{}; {}, {}, {}", text, plural(jitter, "jitter"), plural(poisson, "nu"),
                     plural(stretches, "stretch"));
}

bool same_state(const AtlasRow& a, const AtlasRow& b) {
  return a.body == b.body && a.jitter == b.jitter && a.poisson == b.poisson &&
         a.stretch == b.stretch;
}

/// Methods to look for as a cure, the nearest to the sick one first.
std::vector<std::string> cures_of(const AtlasRow& row) {
  const std::string support =
      std::isnan(row.support) ? std::string("2.5") : fmt::format("{}", row.support);
  switch (row.verdict) {
    case Verdict::growing:
      return {"mirror " + support, "mirror 2.5", "stress-point", "stress-point cells + S"};
    case Verdict::refused:
      return {"mirror " + support, "variational 1.5", "variational 1.5 + S", "stress-point",
              "stress-point cells + S"};
    case Verdict::soft:
      return {row.method + " + S", "stress-point cells + S", "stress-point"};
    default:
      return {"stress-point cells + S", "stress-point"};
  }
}

/// A row that differs from the sick one in the method only and holds.
const AtlasRow* cured(const Atlas& atlas, const AtlasRow& sick) {
  for (const std::string& method : cures_of(sick))
    for (const AtlasRow& row : atlas.rows)
      if (row.method == method && same_state(row, sick) && holds(row)) return &row;
  if (!sick.body.starts_with("strip")) return nullptr;
  for (const AtlasRow& row : atlas.rows)  // the thinnest that can be built
    if (row.method == "stress-point cells + S" && row.body == "strip of 2" && row.excursion < 1.1)
      return &row;
  return nullptr;
}

/// The same method where its material carries waves: the next smaller Poisson ratio; where none is
/// small enough, the nearest stretch.
const AtlasRow* within_hyperbolicity(const Atlas& atlas, const AtlasRow& sick) {
  const AtlasRow* softer = nullptr;
  const AtlasRow* nearer = nullptr;
  const auto distance = [&](const AtlasRow& row) {
    return std::abs(std::log(row.stretch / sick.stretch));
  };
  for (const AtlasRow& row : atlas.rows) {
    if (row.method != sick.method || row.body != sick.body || row.jitter != sick.jitter ||
        !holds(row))
      continue;
    if (row.stretch == sick.stretch && row.poisson < sick.poisson &&
        (softer == nullptr || row.poisson > softer->poisson))
      softer = &row;
    if (row.poisson == sick.poisson && (nearer == nullptr || distance(row) < distance(*nearer)))
      nearer = &row;
  }
  return softer != nullptr ? softer : nearer;
}

double severity(const AtlasRow& row) {
  const PerturbedRun* run = run_of(row, "0.95");
  if (row.verdict == Verdict::soft) return row.excursion;
  return run == nullptr || std::isnan(run->seen) ? 0.0 : run->seen;
}

std::string evidence(const AtlasRow& row) {
  switch (row.verdict) {
    case Verdict::refused:
      return fmt::format("{}: {}", row.name, row.refusal);
    case Verdict::soft:
      return std::isnan(row.excursion)
                 ? fmt::format("{}: {} modes below half the first true ω²", row.name, row.soft)
                 : fmt::format(
                       "{}: {} modes below half the first true ω²; a run in the lowest goes "
                       "{:.1f} times as far as the first true vibration",
                       row.name, row.soft, row.excursion);
    case Verdict::material: {
      const PerturbedRun* run = run_of(row, "0.95");
      const std::string tensor = fmt::format("acoustic tensor {:.2g} of λ + 2μ", row.acoustic);
      return run == nullptr ? row.name + ": " + tensor : grows(row, *run) + ", " + tensor;
    }
    default:
      return grows(row, *run_of(row, "0.95"));
  }
}

/// One region: its worst row that has a cure, and the cure.
Failure region(const Atlas& atlas, const Rows& rows, const Words& words) {
  Failure failure{extent_of_states(rows), words.what, words.why, words.cure, "", "", 0};
  failure.states = static_cast<Index>(rows.size());
  const AtlasRow* worst = nullptr;
  const AtlasRow* cure = nullptr;
  for (const AtlasRow* row : rows) {
    const AtlasRow* found =
        row->verdict == Verdict::material ? within_hyperbolicity(atlas, *row) : cured(atlas, *row);
    const bool better =
        worst == nullptr || (cure == nullptr && found != nullptr) ||
        ((cure == nullptr) == (found == nullptr) && severity(*row) > severity(*worst));
    if (!better) continue;
    worst = row;
    cure = found;
  }
  failure.evidence = evidence(*worst);
  failure.cured = cure == nullptr ? "no row of this atlas" : stays(*cure);
  return failure;
}

/// Rows that fail in one way, by verdict and what tells apart why.
std::map<std::string, Rows> groups_of(const Atlas& atlas) {
  std::map<std::string, Rows> groups;
  for (const AtlasRow& row : atlas.rows) {
    if (row.verdict == Verdict::stable) continue;
    std::string key(group_of(row));
    groups[key].push_back(&row);
  }
  return groups;
}

}  // namespace

std::vector<Failure> failures_of(const Atlas& atlas) {
  std::vector<Failure> failures;
  for (const auto& [key, rows] : groups_of(atlas))
    failures.push_back(region(atlas, rows, words_of(key)));
  add_long_steps(atlas, failures);
  add_imbalance(atlas, failures);
  add_contrast(atlas, failures);
  add_crush(atlas, failures);
  return failures;
}

}  // namespace tlsph

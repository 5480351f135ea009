#include "failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

#include "evidence.hpp"

namespace tlsph {
namespace {

using Rows = std::vector<const AtlasRow*>;

/// What fails, why, and what cures it.
struct Words {
  const char *group, *what, *why, *cure;
};

// In the order of the story: what the material does, what operators do, what cannot be built.
constexpr std::array entries = {
    Words{
        "1 material", "every method grows, at any step and any spacing",
        "the law has lost hyperbolicity: its acoustic tensor is not positive, so a homogeneous "
        "state "
        "cannot exist",
        "none in the method: a smaller Poisson ratio or a stretch nearer to 1, or a law that stays "
        "hyperbolic"},
    Words{
        "2 compression", "ω² < 0 though the material carries waves, growth at any step",
        "under pressure the tangent weighs Σ V (∂₁u₁ ∂₂u₂ − ∂₂u₁ ∂₁u₂), which is zero for every "
        "motion "
        "that vanishes at the boundary, with μ − λ ln J; gradients of collocated operators do not "
        "keep it zero beside boundaries and on irregular particles",
        "stress points in cells, whose mean gradients keep that sum exactly; a stabiliser shifts "
        "the "
        "onset"},
    Words{"3 tension", "ω² < 0 in tension of nearly incompressible material",
          "the same sum, weighed with −λ ln J", "stress points in cells"},
    Words{"4 growing", "oscillations that grow at any step",
          "D is not the adjoint of G: the forces come from no energy, ω² is complex",
          "an adjoint pair, or mirrored ghosts; narrow supports only slow it down"},
    Words{"5 soft", "modes without energy, to be excited by anything",
          "G u vanishes for fields that change sign from particle to particle",
          "the stabiliser S, or a viscosity; stress points between the particles"},
    Words{"6 weak",
          "modes with less than half the energy of the first true vibration, in spite of S",
          "the stabiliser's 0.1 μ is little beside λ + 2μ, and jittered kernels weigh it down",
          "stress points in cells, whose hourglass stiffness has the right size"},
    Words{"7 no gradient", "no operators: too few neighbours",
          "a plane cannot be fitted through them",
          "a support of 1.5 or more, or the nodes of a cell"},
    Words{"7 thin body", "no operators: a body one particle thick has no gradient across",
          "particles in a row span a line",
          "two layers of particles: stress points in one layer of cells bend as they should"},
    Words{"8 ghosts", "the uniform state cannot be set up: det F <= 0 in it",
          "ghosts are solved for, and the solution oscillates beside the boundary",
          "mirrored ghosts, or no ghosts at all"},
    Words{"9 not for it", "no operators: the method is not made for this body",
          "what it asks of the body is said below", "a method of the others"},
};

/// The way in which a row that is not stable fails; rows of one group are told of together.
std::string group_of(const AtlasRow& row) {
  switch (row.verdict) {
    case Verdict::material:
      return "1 material";
    case Verdict::negative:
      return row.stretch < 1.0 ? "2 compression" : "3 tension";
    case Verdict::growing:
      return "4 growing";
    case Verdict::soft:
      return row.method.ends_with("+ S") ? "6 weak" : "5 soft";
    case Verdict::refused:
      if (row.refusal.find("det F") != std::string::npos) return "8 ghosts";
      if (row.refusal.find("do not determine") == std::string::npos) return "9 not for it";
      return row.body == "scene" ? "7 no gradient" : "7 thin body";
    case Verdict::stable:
      break;
  }
  return "";
}

const Words& words_of(std::string_view group) {
  const auto* const found = std::ranges::find(entries, group, &Words::group);
  assert(found != entries.end());
  return *found;
}

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

#include "failures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "studies.hpp"

namespace tlsph {
namespace {

bool refused_for(const AtlasRow& row, const char* reason) {
  return row.verdict == Verdict::refused && row.refusal.find(reason) != std::string::npos;
}
bool no_gradient(const AtlasRow& row) {
  return refused_for(row, "do not determine") && !refused_for(row, "det F");
}

/// A way in which states fail: which do, what is seen, why, and what cures it.
struct FailureMode {
  bool (*of)(const AtlasRow&);
  const char *what, *why, *cure;
};

// The material first, then the operators, then what cannot be built.
constexpr std::array failure_modes = {
    FailureMode{
        [](const AtlasRow& row) { return row.verdict == Verdict::material; },
        "every method grows, at any step and any spacing",
        "the law has lost hyperbolicity: its acoustic tensor is not positive, so a homogeneous "
        "state cannot exist",
        "none in the method: a smaller Poisson ratio or a stretch nearer to 1, or a law that stays "
        "hyperbolic"},
    FailureMode{
        [](const AtlasRow& row) { return row.verdict == Verdict::negative && row.stretch < 1.0; },
        "ω² < 0 though the material carries waves, growth at any step",
        "under pressure the tangent weighs Σ V (∂₁u₁ ∂₂u₂ − ∂₂u₁ ∂₁u₂), which is zero for every "
        "motion that vanishes at the boundary, with μ − λ ln J; gradients of collocated operators "
        "do not keep it zero beside boundaries and on irregular particles",
        "stress points in cells, whose mean gradients keep that sum exactly; a stabiliser shifts "
        "the onset"},
    FailureMode{
        [](const AtlasRow& row) { return row.verdict == Verdict::negative && row.stretch >= 1.0; },
        "ω² < 0 in tension of nearly incompressible material", "the same sum, weighed with −λ ln J",
        "stress points in cells"},
    FailureMode{[](const AtlasRow& row) { return row.verdict == Verdict::growing; },
                "oscillations that grow at any step",
                "D is not the adjoint of G: the forces come from no energy, ω² is complex",
                "an adjoint pair, or mirrored ghosts; narrow supports only slow it down"},
    FailureMode{[](const AtlasRow& row) {
                  return row.verdict == Verdict::zero_energy && !row.method.ends_with("+ S");
                },
                "modes without energy, to be excited by anything",
                "G u vanishes for fields that change sign from particle to particle",
                "the stabiliser S, or a viscosity; stress points between the particles"},
    FailureMode{
        [](const AtlasRow& row) {
          return row.verdict == Verdict::zero_energy && row.method.ends_with("+ S");
        },
        "modes with less than half the energy of the first true vibration, in spite of S",
        "the stabiliser's 0.1 μ is little beside λ + 2μ, and jittered kernels weigh it down",
        "stress points in cells, whose hourglass stiffness has the right size"},
    FailureMode{[](const AtlasRow& row) { return no_gradient(row) && row.body == "scene"; },
                "no operators: too few neighbours", "a plane cannot be fitted through them",
                "a support of 1.5 or more, or the nodes of a cell"},
    FailureMode{[](const AtlasRow& row) { return no_gradient(row) && row.body != "scene"; },
                "no operators: a body one particle thick has no gradient across",
                "particles in a row span a line",
                "two layers of particles: stress points in one layer of cells bend as they should"},
    FailureMode{[](const AtlasRow& row) { return refused_for(row, "det F"); },
                "the uniform state cannot be set up: det F <= 0 in it",
                "ghosts are solved for, and the solution oscillates beside the boundary",
                "mirrored ghosts, or no ghosts at all"},
    FailureMode{[](const AtlasRow& row) {
                  return row.verdict == Verdict::refused && !refused_for(row, "det F") &&
                         !no_gradient(row);
                },
                "no operators: the method is not made for this body",
                "what it asks of the body is said below", "a method of the others"},
};

std::string range_text(const std::set<double>& values, const char* name) {
  if (values.size() == 1) return fmt::format("{} {}", name, *values.begin());
  return fmt::format("{} {} to {}", name, *values.begin(), *values.rbegin());
}

/// Methods, layouts and parameters of the rows that fail in this way, and their number.
std::pair<std::string, Index> extent_of(const Atlas& atlas, const FailureMode& mode) {
  std::vector<std::string> methods;
  std::set<double> jitter, poisson, stretches;
  std::set<std::string> bodies;
  Index count = 0;
  for (const AtlasRow& row : atlas.rows) {
    if (!mode.of(row)) continue;
    ++count;
    if (std::ranges::find(methods, row.method) == methods.end()) methods.push_back(row.method);
    jitter.insert(row.jitter);
    poisson.insert(row.poisson);
    stretches.insert(row.stretch);
    bodies.insert(row.body);
  }
  if (count == 0) return {};
  std::string text = methods.size() > 6 ? fmt::format("{} methods", methods.size())
                                        : fmt::format("{}", fmt::join(methods, ", "));
  if (bodies.size() == 1 && *bodies.begin() != "scene") text += ", " + *bodies.begin();
  return {fmt::format("{}; {}, {}, {}", text, range_text(jitter, "jitter"),
                      range_text(poisson, "nu"), range_text(stretches, "stretch")),
          count};
}

/// Methods that may cure a row, the nearest to its own first.
std::vector<std::string> other_methods(const AtlasRow& row) {
  const std::string mirror =
      std::isnan(row.support) ? std::string("mirror 2.5") : fmt::format("mirror {}", row.support);
  switch (row.verdict) {
    case Verdict::growing:
      return {mirror, "mirror 2.5", "stress-point", "stress-point cells + S"};
    case Verdict::refused:
      return {mirror, "variational 1.5", "variational 1.5 + S", "stress-point",
              "stress-point cells + S"};
    case Verdict::zero_energy:
      return {row.method + " + S", "stress-point cells + S", "stress-point"};
    default:
      return {"stress-point cells + S", "stress-point"};
  }
}

/// The same method where its material carries waves: the next smaller Poisson ratio; where none is
/// small enough, the nearest stretch.
const AtlasRow* within_hyperbolicity(const Atlas& atlas, const AtlasRow& failing) {
  const auto like = [&](const AtlasRow& row) {
    return row.method == failing.method && row.body == failing.body &&
           row.jitter == failing.jitter && confirmed_stable(row);
  };
  const AtlasRow* softer = largest(
      atlas.rows,
      [&](const AtlasRow& row) {
        return like(row) && row.stretch == failing.stretch && row.poisson < failing.poisson;
      },
      [](const AtlasRow& row) { return row.poisson; });
  if (softer != nullptr) return softer;
  return largest(
      atlas.rows, [&](const AtlasRow& row) { return like(row) && row.poisson == failing.poisson; },
      [&](const AtlasRow& row) { return -std::abs(std::log(row.stretch / failing.stretch)); });
}

/// A stable row that differs from the failing one in the method only, if there is one; of a strip
/// the thinnest that can be built.
const AtlasRow* cure_of(const Atlas& atlas, const AtlasRow& failing) {
  if (failing.verdict == Verdict::material) return within_hyperbolicity(atlas, failing);
  const auto first = [&](const auto& chosen) {
    return largest(atlas.rows, chosen, [](const AtlasRow&) { return 0; });
  };
  for (const std::string& method : other_methods(failing))
    if (const AtlasRow* row = first([&](const AtlasRow& other) {
          return other.method == method && same_state(other, failing) && confirmed_stable(other);
        }))
      return row;
  return !failing.body.starts_with("strip") ? nullptr : first([](const AtlasRow& row) {
    return row.method == "stress-point cells + S" && row.body == "strip of 2" &&
           row.excursion < 1.1;
  });
}

double severity(const AtlasRow& row) {
  if (row.verdict == Verdict::zero_energy) return row.excursion;
  const PerturbedRun* run = row.run("0.95");
  return run == nullptr || std::isnan(run->seen) ? 0.0 : run->seen;
}

/// What was seen of a failing row.
std::string failing_text(const AtlasRow& row) {
  const PerturbedRun* run = row.run("0.95");
  if (row.verdict == Verdict::refused) return fmt::format("{}: {}", row.name, row.refusal);
  if (row.verdict == Verdict::zero_energy) {
    const std::string modes =
        fmt::format("{}: {} modes below half the first true ω²", row.name, row.zero_energy_modes);
    if (std::isnan(row.excursion)) return modes;
    return modes + fmt::format(
                       "; a run in the lowest goes {:.1f} times as far as the first true "
                       "vibration",
                       row.excursion);
  }
  if (row.verdict != Verdict::material) return growth_text(row, *run);
  const std::string tensor = fmt::format("acoustic tensor {:.2g} of λ + 2μ", row.acoustic);
  return run == nullptr ? row.name + ": " + tensor : growth_text(row, *run) + ", " + tensor;
}

}  // namespace

bool confirmed_stable(const AtlasRow& row) {
  const PerturbedRun* run = row.run("0.95");
  return row.verdict == Verdict::stable && run != nullptr && run->bounded();
}

std::string bounded_text(const AtlasRow& row) {
  const PerturbedRun& run = *row.run("0.95");
  std::string text =
      fmt::format("{}: bounded over {} steps at 0.95 of the critical one", row.name, run.steps);
  if (!std::isnan(run.energy_drift)) text += fmt::format(", energy to {:.1e}", run.energy_drift);
  if (!std::isnan(row.excursion))
    text += fmt::format(", lowest mode {:.2f} of the first true vibration", row.excursion);
  return text;
}

std::string growth_text(const AtlasRow& row, const PerturbedRun& run) {
  std::string text = fmt::format("{}: a displacement of 1e-10 spacings grows by e^{:.3g} a step",
                                 row.name, run.seen);
  // With a viscosity the squares of the spectrum alone do not tell.
  if (!std::isnan(run.expected)) text += fmt::format(" (spectrum: {:.3g})", run.expected);
  text += fmt::format(" at {:.3g} of the critical one", run.ratio);
  if (run.lost_at >= 0) text += fmt::format(", det F <= 0 at step {}", run.lost_at);
  return text;
}

bool same_state(const AtlasRow& a, const AtlasRow& b) {
  return a.body == b.body && a.jitter == b.jitter && a.poisson == b.poisson &&
         a.stretch == b.stretch;
}

std::vector<Failure> failures_of(const Atlas& atlas) {
  std::vector<Failure> failures;
  for (const FailureMode& mode : failure_modes) {
    const auto [where, count] = extent_of(atlas, mode);
    if (count == 0) continue;
    // Rows that have a cure first, then those that fail most plainly.
    const AtlasRow* worst = largest(atlas.rows, mode.of, [&](const AtlasRow& row) {
      return std::tuple(cure_of(atlas, row) != nullptr, severity(row));
    });
    const AtlasRow* cure = cure_of(atlas, *worst);
    failures.push_back({where, mode.what, mode.why, mode.cure, failing_text(*worst),
                        cure == nullptr ? "no row of this atlas" : bounded_text(*cure), count});
  }
  add_failures_of_runs(atlas, failures);
  return failures;
}

}  // namespace tlsph

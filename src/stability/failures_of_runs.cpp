#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "failures.hpp"

namespace tlsph {
namespace {

/// A uniform state whose particles move faster than this by themselves [c_p] is not at rest.
constexpr double drift_limit = 1e-6;

/// Bounded at 0.95 of the critical step and not in the run `label`. Of the rule h/c the rows of the
/// formulation that made it come first, wide supports before narrow ones; then the fastest growth.
void add_long_step(const Atlas& atlas, const char* label, Failure failure,
                   std::vector<Failure>& failures) {
  const auto lost = [&](const AtlasRow& row) {
    const PerturbedRun* run = row.run(label);
    return run != nullptr && !run->bounded() && row.run("0.95")->bounded();
  };
  const bool rule = std::string_view(label) == "h/c";
  const AtlasRow* row = largest(atlas.rows, lost, [&](const AtlasRow& one) {
    return std::tuple(rule && one.formulation == "thesis", rule ? one.support : 0.0,
                      rule ? -one.poisson : 0.0, one.run(label)->seen);
  });
  if (row == nullptr) return;
  failure.run = growth_text(*row, *row->run(label));
  failure.cured_run = bounded_text(*row);
  failure.states = std::ranges::count_if(atlas.rows, lost);
  failures.push_back(failure);
}

void add_long_steps(const Atlas& atlas, std::vector<Failure>& failures) {
  add_long_step(
      atlas, "1.02",
      {"every method, 1.02 of its critical step", "growth in the shortest waves the operators see",
       "the fastest mode leaves the unit circle at ω Δt = 2",
       "time.safety below 1; the critical step is that of the run's own operators", "", "", 0},
      failures);
  add_long_step(
      atlas, "h/c",
      {"collocated methods at the step h/c of the thesis, (4.47)", "growth from the first step on",
       "the rule knows neither kernel nor Poisson ratio: 1/ω_max does not grow in "
       "proportion to the support, and c is that of a thin bar",
       "the computed step", "", "", 0},
      failures);
}

/// The same state on stress points, nullptr if the atlas has none.
const AtlasRow* on_stress_points(const Atlas& atlas, const AtlasRow& like) {
  for (const char* method : {"stress-point cells + S", "stress-point"})
    for (const AtlasRow& row : atlas.rows)
      if (row.method == method && same_state(row, like)) return &row;
  return nullptr;
}

/// Uniform stress that the operators do not balance.
void add_imbalance(const Atlas& atlas, std::vector<Failure>& failures) {
  const auto moves = [](const AtlasRow& row) {
    return row.drift > drift_limit && row.verdict != Verdict::material;
  };
  const AtlasRow* worst = largest(
      atlas.rows,
      [&](const AtlasRow& row) {
        return moves(row) && row.formulation != "stress-point" &&
               on_stress_points(atlas, row) != nullptr;
      },
      [](const AtlasRow& row) { return row.drift; });
  if (worst == nullptr) return;
  const AtlasRow& cure = *on_stress_points(atlas, *worst);
  failures.push_back(
      {"uniform stress on irregular particles or beside a boundary, plain and corrected gradients",
       "a body that should rest moves",
       "the adjoint of a gradient that is exact for linear fields need not be exact for constant "
       "stress: nodal sums break the divergence theorem",
       "stress points in cells, or formulation \"consistent\", whose columns are made exact",
       fmt::format("{}: force {:.2g} of the stress, {} from rest", worst->name, worst->imbalance,
                   std::isinf(worst->drift) ? "det F <= 0 within 200 steps"
                                            : fmt::format("speeds up to {:.2g} c_p", worst->drift)),
       fmt::format("{}: force {:.1e}, speeds up to {:.1e} c_p", cure.name, cure.imbalance,
                   cure.drift),
       std::ranges::count_if(atlas.rows, moves)});
}

/// Kernel sums that follow the particles.
void add_contrast(const Atlas& atlas, std::vector<Failure>& failures) {
  const auto grows = [](const ContrastRow& row) { return row.seen > 0.0; };
  const ContrastRow* worst =
      largest(atlas.contrast, grows, [](const ContrastRow& row) { return row.seen; });
  if (worst == nullptr) return;
  const AtlasRow* cure = largest(
      atlas.rows,
      [](const AtlasRow& row) {
        return row.stretch > 1.0 && row.jitter == 0.0 &&
               row.method.starts_with("variational 2.5") && confirmed_stable(row);
      },
      [](const AtlasRow& row) { return -row.stretch; });
  failures.push_back(
      {fmt::format("updated Lagrangian, tension from {:g} ρc² on",
                   atlas.contrast.size() > 2 ? 0.05 : worst->stress),
       "tensile instability: particles gather in clumps",
       "a kernel that moves with the particles turns the stress into a force along the "
       "displacement, 2σ₀ Σ V (1 − cos k·d) ∇∇W, which no stiffness opposes at the shortest wave",
       "kernels of the reference configuration: the sum above is not there in total-Lagrangian "
       "form",
       fmt::format("cubic spline, support 2.4, stress {:g} ρc²: grows at {:.3g} c/Δ (linearised "
                   "sums: {:.3g}), kinetic energy {:.0e} of the first",
                   worst->stress, worst->seen, worst->expected, worst->amplitude),
       cure == nullptr ? "no row of this selection" : bounded_text(*cure),
       std::ranges::count_if(atlas.contrast, grows)});
}

/// The same compression with an adapted step that reached its end, nullptr if there is none.
const CompressionRow* adapted(const Atlas& atlas, const CompressionRow& like) {
  const auto found = std::ranges::find_if(atlas.compression, [&](const CompressionRow& row) {
    return row.step == "followed" && row.failure.empty() && row.method == like.method &&
           row.motion == like.motion && row.speed == like.speed;
  });
  return found == atlas.compression.end() ? nullptr : &*found;
}

/// Compression at a step that is not adapted.
void add_compression(const Atlas& atlas, std::vector<Failure>& failures) {
  const auto fails = [](const CompressionRow& row) {
    return row.step != "followed" && !row.failure.empty();
  };
  const CompressionRow* worst = largest(
      atlas.compression,
      [&](const CompressionRow& row) { return fails(row) && adapted(atlas, row) != nullptr; },
      [](const CompressionRow& row) { return row.closest; });
  if (worst == nullptr) return;
  const CompressionRow& cure = *adapted(atlas, *worst);
  failures.push_back(
      {"compression to a stretch of 0.2 at the step of the undeformed body",
       "det F <= 0 long before that",
       "the tangent grows as 1/λ²: the critical step falls with the stretch and faster",
       "a step that follows the body, as runs do by themselves",
       fmt::format(
           "{}, edge at {:g} c_p: {:.1f} times the critical step, det F <= 0 after {} steps",
           worst->method, worst->speed, worst->closest, worst->steps),
       fmt::format("{}: to the end in {} steps, never above {:.3f} of the critical one, {} new "
                   "estimate{}, {:.1f} % of the stepping time",
                   cure.method, cure.steps, cure.closest, cure.estimates - 1,
                   cure.estimates == 2 ? "" : "s", 100.0 * cure.share),
       std::ranges::count_if(atlas.compression, fails)});
}

}  // namespace

void add_failures_of_runs(const Atlas& atlas, std::vector<Failure>& failures) {
  add_long_steps(atlas, failures);
  add_imbalance(atlas, failures);
  add_contrast(atlas, failures);
  add_compression(atlas, failures);
}

}  // namespace tlsph

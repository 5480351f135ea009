#include "evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tlsph {
namespace {

/// A uniform state that moves by itself faster than this [c_p] is none.
constexpr double unrest_limit = 1e-6;

const AtlasRow* row_of(const Atlas& atlas, const std::string& method, const AtlasRow& like) {
  for (const AtlasRow& row : atlas.rows)
    if (row.method == method && row.body == like.body && row.jitter == like.jitter &&
        row.poisson == like.poisson && row.stretch == like.stretch)
      return &row;
  return nullptr;
}

/// Of the rows whose run stays bounded at 0.95 and does not in the run of that label, the one that
/// grows fastest; of the rule h/c first those of the formulation that made it, wide supports before
/// narrow ones.
const AtlasRow* fastest(const Atlas& atlas, const std::string& label, Index& count) {
  const AtlasRow* worst = nullptr;
  const auto before = [&](const AtlasRow& a, const AtlasRow& b) {
    if (label == "h/c") {
      const auto rank = [](const AtlasRow& row) {
        return std::tuple(row.formulation == "thesis", row.support, -row.poisson);
      };
      if (rank(a) != rank(b)) return rank(a) > rank(b);
    }
    return run_of(a, label)->seen > run_of(b, label)->seen;
  };
  count = 0;
  for (const AtlasRow& row : atlas.rows) {
    const PerturbedRun* run = run_of(row, label);
    const PerturbedRun* below = run_of(row, "0.95");
    if (run == nullptr || run->bounded() || !below->bounded()) continue;
    ++count;
    if (worst == nullptr || before(row, *worst)) worst = &row;
  }
  return worst;
}

}  // namespace

const PerturbedRun* run_of(const AtlasRow& row, const std::string& label) {
  for (const PerturbedRun& run : row.runs)
    if (run.label == label) return &run;
  return nullptr;
}

bool holds(const AtlasRow& row) {
  const PerturbedRun* run = run_of(row, "0.95");
  return row.verdict == Verdict::stable && run != nullptr && run->bounded();
}

std::string stays(const AtlasRow& row) {
  const PerturbedRun& run = *run_of(row, "0.95");
  std::string text =
      fmt::format("{}: bounded over {} steps at 0.95 of the critical one", row.name, run.steps);
  if (!std::isnan(run.energy_drift)) text += fmt::format(", energy to {:.1e}", run.energy_drift);
  if (!std::isnan(row.excursion))
    text += fmt::format(", lowest mode {:.2f} of the first true vibration", row.excursion);
  return text;
}

std::string grows(const AtlasRow& row, const PerturbedRun& run) {
  std::string text = fmt::format("{}: a displacement of 1e-10 spacings grows by e^{:.3g} a step",
                                 row.name, run.seen);
  // With a viscosity the squares of the spectrum alone do not tell.
  if (!std::isnan(run.expected)) text += fmt::format(" (spectrum: {:.3g})", run.expected);
  text += fmt::format(" at {:.3g} of the critical one", run.ratio);
  if (run.lost_at >= 0) text += fmt::format(", det F <= 0 at step {}", run.lost_at);
  return text;
}

void add_long_steps(const Atlas& atlas, std::vector<Failure>& failures) {
  Index count = 0;
  if (const AtlasRow* row = fastest(atlas, "1.02", count))
    failures.push_back({"every method, 1.02 of its critical step",
                        "growth in the shortest waves the operators see",
                        "the fastest mode leaves the unit circle at ω Δt = 2",
                        "time.safety below 1; the critical step is that of the run's own operators",
                        grows(*row, *run_of(*row, "1.02")), stays(*row), count});
  if (const AtlasRow* row = fastest(atlas, "h/c", count))
    failures.push_back({"collocated methods at the step h/c of the thesis, (4.47)",
                        "growth from the first step on",
                        "the rule knows neither kernel nor Poisson ratio: 1/ω_max does not grow in "
                        "proportion to the support, and c is that of a thin bar",
                        "the computed step", grows(*row, *run_of(*row, "h/c")), stays(*row),
                        count});
}

void add_imbalance(const Atlas& atlas, std::vector<Failure>& failures) {
  const AtlasRow* worst = nullptr;
  Index count = 0;
  for (const AtlasRow& row : atlas.rows) {
    if (!(row.unrest > unrest_limit) || row.verdict == Verdict::material) continue;
    ++count;
    const bool cell = row.formulation == "stress-point";
    if (!cell && (worst == nullptr || row.unrest > worst->unrest) &&
        (row_of(atlas, "stress-point cells + S", row) || row_of(atlas, "stress-point", row)))
      worst = &row;
  }
  if (worst == nullptr) return;
  const AtlasRow* cure = row_of(atlas, "stress-point cells + S", *worst);
  if (cure == nullptr) cure = row_of(atlas, "stress-point", *worst);
  failures.push_back(
      {"uniform stress on irregular particles or beside a boundary, plain and corrected gradients",
       "a body that should rest moves",
       "the adjoint of a gradient that is exact for linear fields need not be exact for constant "
       "stress: nodal sums break the divergence theorem",
       "stress points in cells, or formulation \"consistent\", whose columns are made exact",
       fmt::format("{}: force {:.2g} of the stress, {} from rest", worst->name, worst->imbalance,
                   std::isinf(worst->unrest)
                       ? "det F <= 0 within 200 steps"
                       : fmt::format("speeds up to {:.2g} c_p", worst->unrest)),
       fmt::format("{}: force {:.1e}, speeds up to {:.1e} c_p", cure->name, cure->imbalance,
                   cure->unrest),
       count});
}

void add_contrast(const Atlas& atlas, std::vector<Failure>& failures) {
  const ContrastRow* worst = nullptr;
  Index count = 0;
  for (const ContrastRow& row : atlas.contrast) {
    if (!(row.seen > 0.0)) continue;
    ++count;
    if (worst == nullptr || row.seen > worst->seen) worst = &row;
  }
  if (worst == nullptr) return;
  const AtlasRow* cure = nullptr;
  for (const AtlasRow& row : atlas.rows)
    if (row.stretch > 1.0 && row.jitter == 0.0 && row.method.starts_with("variational 2.5") &&
        holds(row) && (cure == nullptr || row.stretch < cure->stretch))
      cure = &row;
  failures.push_back(
      {fmt::format("updated Lagrangian, tension from {:g} ρc² on",
                   atlas.contrast.size() > 2 ? 0.05 : worst->stress),
       "tensile instability: particles gather in clumps",
       "a kernel that moves with the particles turns the stress into a force along the "
       "displacement, "
       "2σ₀ Σ V (1 − cos k·d) ∇∇W, which no stiffness opposes at the shortest wave",
       "kernels of the reference configuration: the sum above is not there in total-Lagrangian "
       "form",
       fmt::format(
           "cubic spline, support 2.4, stress {:g} ρc²: grows at {:.3g} c/Δ (linearised sums: "
           "{:.3g}), kinetic energy {:.0e} of the first",
           worst->stress, worst->seen, worst->expected, worst->amplitude),
       cure == nullptr ? "no row of this selection" : stays(*cure), count});
}

void add_crush(const Atlas& atlas, std::vector<Failure>& failures) {
  const CrushRow* worst = nullptr;
  const CrushRow* cure = nullptr;
  Index count = 0;
  for (const CrushRow& row : atlas.crush) {
    if (row.follow == "followed" || row.failure.empty()) continue;
    ++count;
    for (const CrushRow& other : atlas.crush)
      if (other.follow == "followed" && other.method == row.method && other.motion == row.motion &&
          other.speed == row.speed && other.failure.empty() &&
          (worst == nullptr || row.closest > worst->closest)) {
        worst = &row;
        cure = &other;
      }
  }
  if (worst == nullptr) return;
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
                   cure->method, cure->steps, cure->closest, cure->estimates - 1,
                   cure->estimates == 2 ? "" : "s", 100.0 * cure->share),
       count});
}

}  // namespace tlsph

#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tlsph {
namespace {

/// A run whose energy drifts further says so.
constexpr double tolerated_drift = 0.01;

}  // namespace

std::string run_report(const Summary& s, const std::filesystem::path& out) {
  std::string text = fmt::format("{} particles, {} material points, {} in {}D, kernel {}\n",
                                 s.particles, s.points, s.formulation, s.dimension, s.kernel);
  text += fmt::format("{} steps to t = {:.6g} s, dt = {:.4g} s (critical {:.4g} s)\n", s.steps,
                      s.end_time, s.dt, s.dt_critical);
  text +=
      fmt::format("{:.3g} s stepping on {} thread{}, {:.3g} ns per particle and step\n",
                  s.wall_stepping, s.threads, s.threads == 1 ? "" : "s", s.ns_per_particle_step);
  text += fmt::format("energy drift {:.1e} of the largest energy\n", s.energy.drift_relative);
  if (s.energy.drift_relative > tolerated_drift)
    text += fmt::format(
        "warning: the energy left its balance by {:.2g} % of the largest energy; a smaller "
        "time.safety shows what it owes to the step, time.energy_tolerance ends such runs\n",
        100.0 * s.energy.drift_relative);
  if (s.errors)
    text += fmt::format(
        "errors against the exact solution: displacement {:.3e}, velocity {:.3e}, "
        "stress {:.3e}\n",
        s.errors->displacement, s.errors->velocity, s.errors->stress);
  for (const LoadedPatch& load : s.loads) text += load.text() + '\n';
  for (const std::string& warning : s.warnings) text += "warning: " + warning + '\n';
  if (s.hyperbolicity_lost) text += s.hyperbolicity_lost->text() + '\n';
  if (s.interrupted)
    text += fmt::format("interrupted; the state is saved, --resume goes on from here\n");
  return text + fmt::format("results in {}\n", out.string());
}

std::string run_line(const ConvergenceRow& row) {
  const std::string text =
      fmt::format("{}, spacing {:.6g} m, {} particles{}: ", row.series, row.spacing, row.particles,
                  row.sample.empty() ? "" : ", sample " + row.sample);
  if (!row.failure.empty()) return text + fmt::format("failed: {}\n", row.failure);
  return text + fmt::format("{} steps in {:.3g} s\n", row.steps, row.wall_seconds);
}

std::string results_report(const std::filesystem::path& out, const Figure& figure) {
  const std::string text = fmt::format("results in {}", out.string());
  if (figure.drawn) return text + fmt::format(", drawn in {}\n", figure.file.string());
  return text + fmt::format("\nno figure; draw it with: {}\n", figure.command);
}

std::string case_line(const CaseResult& result) {
  const std::string text = fmt::format("{:<24} {:>6.1f} s  ", result.name, result.seconds);
  if (!result.failure.empty()) return text + fmt::format("came to no end: {}\n", result.failure);
  const auto failed =
      std::ranges::count_if(result.checks, [](const Check& c) { return !c.holds(); });
  if (failed > 0) return text + fmt::format("{} of {} checks fail\n", failed, result.checks.size());
  return text +
         fmt::format("{} numbers, all hold{}\n", result.checks.size(),
                     result.undrawn.empty() ? "" : "; no figure, draw it with: " + result.undrawn);
}

}  // namespace tlsph

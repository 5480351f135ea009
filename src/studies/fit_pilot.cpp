#include "fit_pilot.hpp"

#include <algorithm>
#include <cmath>

#include "fit_plan.hpp"
#include "probe_values.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

/// Runs shorter than this are repeated: their time is noise [s].
constexpr double short_run = 0.05;
constexpr int repetitions = 3;
/// What is below is zero: errors have logarithms.
constexpr double zero = 1e-16;
/// Share of the memory that a model may need.
constexpr double usable = 0.8;

double error_of(const FitRequest& request, const Summary& summary, double answer,
                const History& history) {
  if (request.value) return read_values({request.value->name}, history).front() / answer - 1.0;
  const FieldErrors& errors = summary.errors.value();
  if (request.quantity == "displacement") return errors.displacement;
  if (request.quantity == "velocity") return errors.velocity;
  if (request.quantity == "stress") return errors.stress;
  return std::max({errors.displacement, errors.velocity, errors.stress});
}

}  // namespace

std::optional<Pilot> run_pilot(const FitRequest& request, double answer, const Scene& scene,
                               const FitOptions& options, const std::function<void()>& progress) {
  Pilot pilot;
  for (int k = 0; k < repetitions && (k == 0 || pilot.stepping < short_run); ++k) {
    RunOptions run_options;
    run_options.threads = options.threads;
    run_options.stop_requested = options.stop_requested;
    run_options.progress = [&](const Progress&) { progress(); };
    ProbeHistories histories;
    if (request.value) run_options.histories = &histories;
    const Summary summary = run(scene, run_options);
    if (summary.interrupted) return std::nullopt;
    if (k == 0) {
      const double error = error_of(request, summary, answer, histories.computed);
      pilot = {summary.spacing,   summary.wall_setup, summary.wall_stepping,      0.0,
               summary.particles, summary.steps,      error == 0.0 ? zero : error};
    }
    pilot.setup = std::min(pilot.setup, summary.wall_setup);
    pilot.stepping = std::min(pilot.stepping, summary.wall_stepping);
  }
  const bool factorises = scene.formulation == Formulation::thesis || scene.consistency.has_value();
  pilot.charged = pilot.stepping + (factorises ? pilot.setup : 0.0);
  return pilot;
}

void conclude(FitFamily& family, double error, const Scene& scene, int dimension) {
  const auto errors = believed_errors(family.pilots);
  family.order = observed_order(family.pilots, errors);
  // A pilot that lies on the spacing itself counts, whatever its last digits.
  const double spacing = spacing_for(family.pilots, errors, error) * (1.0 + 1e-9);
  family.spacing = next_division(scene, spacing);
  family.reaches = family.spacing > 0.0;
  if (!family.reaches) return;
  const Pilot& finest = family.pilots.back();
  const double particles =
      static_cast<double>(finest.particles) * std::pow(finest.spacing / family.spacing, dimension);
  if (operator_bytes(scene, particles) + correction_bytes(scene, particles) >
      usable * machine_bytes()) {
    family.reaches = false;
    family.note = "more memory than there is";
    return;
  }
  family.predicted_error = predicted_error(family.pilots, errors, family.spacing);
  family.predicted_seconds = predicted_seconds(family.pilots, family.spacing, dimension);
}

}  // namespace tlsph

#include "fit_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "chart_plan.hpp"
#include "readings.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/filling/division.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/linear_law.hpp"
#include "tlsph/simulation/reduction.hpp"

namespace tlsph {
namespace {

/// What is the model's to choose.
constexpr std::array<const char*, 14> chosen = {
    "formulation", "boundary_treatment", "boundary_solver", "precision",     "consistency",
    "kernel",      "stabiliser",         "output",          "time.step",     "body.fit",
    "body.jitter", "body.seed",          "body.layout",     "body.placement"};
/// Choices of a family that may differ from the defaults of its formulation; kernels differ little.
constexpr int variety = 1;

/// A scene may set these keys for its own run; an override that sets one contradicts the fit.
void check_overrides(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) {
    const std::string key = text.substr(0, text.find('='));
    for (const std::string_view name : chosen) {
      if (name == "output" || (key != name && !key.starts_with(fmt::format("{}.", name)))) continue;
      throw InputError(
          {"--set " + text, 0, 0, ""},
          fmt::format("{} is what a fit chooses; leave it out, or run the scene", name));
    }
  }
}

void check(const FitRequest& request, const Scene& scene) {
  check_overrides(request.overrides);
  if (!(request.error > 0.0 && request.error < 1.0))
    throw InputError(
        {"--error", 0, 0, ""},
        fmt::format("{} is no relative error; allowed: above 0, below 1", request.error));
  if (!request.quantity.empty()) {
    const Place option{"--quantity", 0, 0, ""};
    if (std::ranges::find(error_fields, request.quantity, &ErrorField::name) == error_fields.end())
      throw InputError(option, fmt::format("there is no \"{}\"; choose from displacement, "
                                           "velocity, stress",
                                           request.quantity));
    if (request.value) throw InputError(option, "goes without --value: a field or a number");
    if (scene.exact == ExactKind::none)
      throw InputError(option,
                       "fields are held against reference.exact, which the scene has not; "
                       "give --value NAME[=ANSWER]");
  }
  if (!scene.body.cloud.empty())
    throw InputError(scene.body.cloud_place,
                     "points of a file have a spacing of their own, and that is what is chosen "
                     "here: leave the cloud out, the shape is filled");
}

/// The probe and the quantity behind "<probe>.<quantity>[_component].<word>".
struct Read {
  std::size_t probe = 0;
  std::string quantity, component;
};

Read read_of(const std::string& value, const Scene& scene) {
  const std::string column = value.substr(0, value.rfind('.'));
  for (std::size_t k = 0; k < scene.probes.size(); ++k) {
    const ProbeScene& probe = scene.probes[k];
    if (!column.starts_with(probe.name + ".")) continue;
    const std::string quantity = column.substr(probe.name.size() + 1);
    for (const std::string& stem : probe.record) {
      if (quantity == stem) return {k, stem, ""};
      if (quantity.starts_with(stem + "_")) return {k, stem, quantity.substr(stem.size() + 1)};
    }
  }
  return {};
}

/// Without what is the model's to choose, and of the probes the one that is read.
Scene bare(const Scene& scene, const FitRequest& request) {
  const Scene standard;
  Scene bare = scene;
  bare.formulation = standard.formulation;
  bare.ghosts = standard.ghosts;
  bare.boundary_solver = standard.boundary_solver;
  bare.precision = standard.precision;
  bare.consistency = standard.consistency;
  bare.kernel = {};
  bare.stabiliser = {};
  bare.output = {};
  bare.output.frames = 0;
  bare.time.step.reset();
  bare.body.fit = standard.body.fit;
  bare.body.jitter = standard.body.jitter;
  bare.body.seed = standard.body.seed;
  bare.body.layout = standard.body.layout;
  bare.body.placement = standard.body.placement;
  bare.probes.clear();
  if (request.value) {
    const Read read = read_of(request.value->name, scene);
    bare.probes = {scene.probes[read.probe]};
    bare.probes.front().record = {read.quantity};
  }
  return completed(bare);
}

/// Takes the smaller scene in place of the plan's, if it is one.
bool reduce(FitPlan& plan, const std::optional<Reduction>& reduction) {
  if (!reduction) return false;
  try {
    plan.scene = completed(reduction->scene);
  } catch (const InputError&) {
    return false;
  }
  plan.reductions.push_back(reduction->what);
  return true;
}

void reduce(FitPlan& plan, const FitRequest& request, const Scene& scene) {
  if (scene.dimension != 2) return;
  const bool reads_y =
      request.value && read_of(request.value->name, scene).component.find('y') != std::string::npos;
  if (!reads_y && reduce(plan, to_one_dimension(plan.scene))) return;
  for (const int axis : {0, 1}) reduce(plan, to_half(plan.scene, axis));
}

template <int D>
double next_division_in(const Scene& scene, double spacing) {
  const Box<D> box = bounding_box(std::get<Shape<D>>(scene.body.shape));
  const double shortest = (box.upper - box.lower).minCoeff();
  const double first = std::max(1.0, std::ceil(shortest / spacing * (1.0 - 1e-9)));
  if (!(first < std::numeric_limits<int>::max())) return 0.0;
  // Beyond 50 cells a length every division fits.
  for (double n = first; n <= first + 100.0; n += 1.0) {
    try {
      (void)divide<D>(box, shortest / n);
      return shortest / n;
    } catch (const InputError&) {
    }
  }
  return 0.0;
}

/// Runs shorter than this are repeated: their time is noise [s].
constexpr double short_run = 0.05;
constexpr int repetitions = 3;
/// Stands for an error of zero, because logarithms of errors are taken.
constexpr double zero = 1e-16;
/// Share of the memory that a model may need.
constexpr double usable = 0.8;

double error_of(const FitRequest& request, const ProbedRun& run, double answer) {
  if (request.value) return read_values({request.value->name}, run.history).front() / answer - 1.0;
  const FieldErrors& errors = run.summary.errors.value();
  for (const ErrorField& field : error_fields)
    if (request.quantity == field.name) return errors.*field.error;
  return std::ranges::max(errors_of(run.summary));
}

}  // namespace

FitPlan plan_fit(const FitRequest& request) {
  const Scene scene = read_scene(request.scene, request.overrides);
  check(request, scene);
  FitPlan plan;
  plan.study.scene = request.scene;
  plan.study.overrides = request.overrides;
  if (request.value) plan.study.values = {*request.value};
  plan.study.spacings = {scene.body.spacing};
  (void)plan_chart(plan.study);
  plan.scene = bare(scene, request);
  reduce(plan, request, scene);
  plan.quantity = request.value              ? request.value->name
                  : request.quantity.empty() ? "worst of displacement, velocity and stress"
                                             : request.quantity;
  for (ChartFamily& family : chart_families(plan.scene.dimension, {})) {
    const std::string_view kernel = traits_of(*from_name<Formulation>(family.formulation)).kernel;
    if (family.distance <= variety && (family.kernel.empty() || family.kernel == kernel))
      plan.families.push_back(std::move(family));
  }
  plan.linear = linear_law(scene);
  return plan;
}

double next_division(const Scene& scene, double spacing) {
  return in_dimension(scene.dimension,
                      [&]<int D>() { return next_division_in<D>(scene, spacing); });
}

std::optional<Pilot> run_pilot(const FitRequest& request, double answer, const Scene& scene,
                               const FitOptions& options, const std::function<void()>& progress) {
  Pilot pilot;
  for (int k = 0; k < repetitions && (k == 0 || pilot.stepping < short_run); ++k) {
    RunOptions run_options;
    run_options.threads = options.threads;
    run_options.stop_requested = options.stop_requested;
    run_options.progress = [&](const Progress&) { progress(); };
    const auto run = run_probed(scene, run_options, request.value.has_value());
    if (!run) return std::nullopt;
    const Summary& summary = run->summary;
    if (k == 0) {
      const double error = error_of(request, *run, answer);
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

void conclude(FitFamily& family, double error, const Scene& scene) {
  const auto errors = believed_errors(family.pilots);
  family.order = observed_order(family.pilots, errors);
  // A pilot that lies on the spacing itself counts, whatever its last digits.
  const double spacing = spacing_for(family.pilots, errors, error) * (1.0 + 1e-9);
  family.spacing = next_division(scene, spacing);
  family.reaches = family.spacing > 0.0;
  if (!family.reaches) return;
  const Pilot& finest = family.pilots.back();
  const double particles = static_cast<double>(finest.particles) *
                           std::pow(finest.spacing / family.spacing, scene.dimension);
  if (operator_bytes(scene, particles) + correction_bytes(scene, particles) >
      usable * machine_bytes()) {
    family.reaches = false;
    family.note = "more memory than there is";
    return;
  }
  family.predicted_error = predicted_error(family.pilots, errors, family.spacing);
  family.predicted_seconds = predicted_seconds(family.pilots, family.spacing, scene.dimension);
}

}  // namespace tlsph

#include "chart_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "convergence_plan.hpp"
#include "peers.hpp"
#include "readings.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

/// Spacings a chart tries of itself: from this many halvings above the scene's to so many below.
constexpr int halvings_above = 2, halvings_below = 6;

/// Refuses a spacing that does not divide the body of the scene.
void check_spacing(const Scene& scene, double spacing) {
  Scene spaced = scene;
  spaced.body.spacing = spacing;
  spaced.body.spacing_place = {fmt::format("--set body.spacing={}", spacing), 0, 0, ""};
  in_dimension(scene.dimension, [&]<int D>() { (void)build_particles<D>(spaced); });
}

/// Spacings that divide the body; those that are asked for must.
std::vector<double> ladder_of(const ChartRequest& request, const Scene& scene) {
  std::vector<double> ladder = sorted_spacings(request.spacings);
  for (const double next : ladder) check_spacing(scene, next);
  if (!ladder.empty()) return ladder;
  // Finer ones divide it where this one does; their particles would only cost memory here.
  for (int halvings = -halvings_above; halvings <= halvings_below; ++halvings) {
    const double next = scene.body.spacing * std::pow(2.0, -halvings);
    try {
      if (halvings < 0) check_spacing(scene, next);
      ladder.push_back(next);
    } catch (const InputError&) {
      ladder.clear();
    }
  }
  return ladder;
}

/// Share of a value that its change from one spacing to the next may be to count as noise.
constexpr double settled = 1e-5;

double limit_of(const ConvergenceValue& value, const std::vector<double>& spacings) {
  if (std::isfinite(value.limit) && value.limit != 0.0) return value.limit;
  if (const std::size_t n = value.medians.size(); n >= 3) {
    const double finest = value.medians[n - 1];
    if (finest != 0.0 && std::abs(finest - value.medians[n - 2]) <= settled * std::abs(finest))
      return finest;
  }
  throw InputError({"--value " + value.name, 0, 0, ""},
                   fmt::format("does not settle at the spacings {:.4g}, {:.4g} and {:.4g}: give "
                               "its answer, {}=…",
                               spacings[0], spacings[1], spacings[2], value.name));
}

}  // namespace

ChartValue parse_chart_value(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return {text, std::nullopt};
  ChartValue value{text.substr(0, equals), 0.0};
  const char* first = text.data() + equals + 1;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, *value.answer);
  if (error != std::errc() || end != last || !std::isfinite(*value.answer) || *value.answer == 0.0)
    throw InputError({"--value " + text, 0, 0, ""},
                     "the answer must be a number that is not zero: errors are relative to it");
  return value;
}

ChartPlan plan_chart(const ChartRequest& request) {
  if (!std::isfinite(request.budget) || request.budget <= 0.0)
    throw InputError({"--budget", 0, 0, ""},
                     fmt::format("{} s is no time; a number > 0", request.budget));
  check_formulations(request.formulations);
  ChartPlan plan;
  plan.scene = read_scene(request.scene, request.overrides);
  if (!plan.scene.body.cloud.empty())
    throw InputError(plan.scene.body.cloud_place,
                     "points of a file have a spacing of their own, and a chart tries many: leave "
                     "the cloud out, the shape is filled");
  for (const ChartValue& value : request.values) plan.values.push_back(value.name);
  check_value_names(plan.values, plan.scene);
  if (plan.scene.exact != ExactKind::none) {
    plan.quantities = error_field_names();
    plan.answers.assign(plan.quantities.size(), not_known);
  } else if (plan.values.empty()) {
    throw InputError({plan.scene.file, 0, 0, ""},
                     "nothing to be near to: no reference.exact; give --value NAME=ANSWER, e.g. "
                     "tip.displacement_y.period=0.25523, or --value NAME to have it extrapolated");
  }
  for (const ChartValue& value : request.values) {
    plan.quantities.push_back(value.name);
    plan.answers.push_back(value.answer.value_or(not_known));
  }
  check_peers(request.peers, request.overrides);
  plan.ladder = ladder_of(request, plan.scene);
  check_buildable(plan.scene);
  return plan;
}

std::vector<double> find_answers(const ChartRequest& request, double h, const StudyOptions& options,
                                 int threads, const std::function<void()>& progress) {
  std::vector<double> answers;
  ConvergenceRequest study;
  for (const ChartValue& value : request.values) {
    answers.push_back(value.answer.value_or(not_known));
    if (!value.answer) study.values.push_back(value.name);
  }
  if (study.values.empty()) return answers;
  study.scene = request.scene;
  study.overrides = request.overrides;
  study.spacings = {2.0 * h, h, 0.5 * h};
  ConvergenceOptions study_options;
  study_options.out = options.out / "answer";
  study_options.threads = threads;
  study_options.stop_requested = options.stop_requested;
  study_options.run_progress = [&](const Progress&) { progress(); };
  const ConvergenceTable table = converge(study, study_options);
  if (table.interrupted) return answers;
  for (const ConvergenceValue& value : table.values)
    for (std::size_t k = 0; k < answers.size(); ++k)
      if (request.values[k].name == value.name) answers[k] = limit_of(value, study.spacings);
  return answers;
}

void ChartStudy::show(const std::string& what) const {
  if (options.progress) options.progress(what, std::min(1.0, spent() / request.budget));
}

void ChartStudy::add(ChartPoint point) {
  table.points.push_back(std::move(point));
  if (table.points.size() % 20 == 0) write();
}

void ChartStudy::write() {
  table.spent = spent();
  table.mark_fronts();
  table.write(options.out);
}

}  // namespace tlsph

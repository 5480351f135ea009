#include "chart_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "convergence_plan.hpp"
#include "peers.hpp"
#include "probe_values.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

/// Spacings a chart tries of itself: from this many halvings above the scene's to so many below.
constexpr int coarsest = 2, finest = 6;

/// Refuses a spacing that does not divide the body of the scene.
void check_spacing(const Scene& scene, double spacing) {
  Scene spaced = scene;
  spaced.body.spacing = spacing;
  spaced.body.spacing_place = {fmt::format("--set body.spacing={}", spacing), 0, 0, ""};
  in_dimension(scene.dimension, [&]<int D>() { (void)build_particles<D>(spaced); });
}

/// Spacings that divide the body; those that are asked for must.
std::vector<double> ladder_of(const ChartRequest& request, const Scene& scene) {
  std::vector<double> ladder;
  if (request.spacings.empty()) {
    // Finer ones divide it where this one does; their particles would only cost memory here.
    for (int halvings = -coarsest; halvings <= finest; ++halvings) {
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
  ladder = sorted_spacings(request.spacings);
  for (const double next : ladder) check_spacing(scene, next);
  return ladder;
}

template <int D>
void check_buildable(const Scene& scene) {
  const Discretisation<D> disc = build<D>(scene);
  (void)build_initial<D>(scene, disc);
  (void)build_exact<D>(scene, disc);
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
    plan.quantities = {"displacement", "velocity", "stress"};
    plan.answers.assign(3, not_known);
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
  in_dimension(plan.scene.dimension, [&]<int D>() { check_buildable<D>(plan.scene); });
  return plan;
}

}  // namespace tlsph

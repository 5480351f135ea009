#include "convergence_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/error.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/builder.hpp"

namespace tlsph {
namespace {

const Place spacing_option{"--spacing", 0, 0, ""};
const Place formulation_option{"--formulation", 0, 0, ""};

std::vector<double> sorted_spacings(std::vector<double> spacings) {
  for (const double spacing : spacings)
    if (!std::isfinite(spacing) || spacing <= 0.0)
      throw InputError(spacing_option, fmt::format("{} is no spacing; a length > 0 [m]", spacing));
  std::ranges::sort(spacings, std::greater());
  const auto twice = std::ranges::adjacent_find(spacings);
  if (twice != spacings.end())
    throw InputError(spacing_option, fmt::format("{} stands twice; each once", *twice));
  return spacings;
}

void check_formulations(const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (!from_name<Formulation>(*name))
      throw InputError(formulation_option, fmt::format("there is no \"{}\"; choose from {}", *name,
                                                       choices<Formulation>()));
    if (std::find(names.begin(), name, *name) != name)
      throw InputError(formulation_option, fmt::format("{} stands twice; each once", *name));
  }
}

/// The scene of one run. Frames are of no use to a study, unless the user asks for them; what the
/// study varies comes last, so that it wins.
Scene scene_of(const ConvergenceRequest& request, const std::string& formulation, double spacing) {
  std::vector<std::string> overrides = {"output.frames=0"};
  overrides.insert(overrides.end(), request.overrides.begin(), request.overrides.end());
  if (!formulation.empty()) overrides.push_back("formulation=" + formulation);
  overrides.push_back(fmt::format("body.spacing={}", spacing));
  return read_scene(request.scene, overrides);
}

template <int D>
void divide(PlannedRun& run) {
  const Particles<D> particles = build_particles<D>(run.scene);
  run.spacing = particles.spacing;
  run.particles = particles.size();
}

/// Builds all a run is made of and lets it go.
template <int D>
void check_buildable(const Scene& scene) {
  const Discretisation<D> disc = build<D>(scene);
  (void)build_initial<D>(scene, disc);
  (void)build_exact<D>(scene, disc);
  std::vector<ProbeRequest<D>> probes;
  for (const ProbeScene& probe : scene.probes)
    probes.push_back({probe.name, Eigen::Map<const Vector<D>>(probe.at.data()), {}});
  (void)Probes<D>(disc, probes);
}

void check_method(const std::vector<double>& spacings, const Scene& scene) {
  const bool exact = scene.exact != ExactKind::none;
  if (!exact && scene.probes.empty())
    throw InputError(
        {scene.file, 0, 0, ""},
        "nothing to compare: neither reference.exact nor a [[probe]]; add one of them");
  const std::size_t least = exact ? 2 : 3;
  if (spacings.size() < least)
    throw InputError(spacing_option,
                     fmt::format("{} given; at least {}{}", spacings.size(), least,
                                 exact ? "" : ", as the scene names no exact solution"));
}

}  // namespace

ConvergencePlan plan_convergence(const ConvergenceRequest& request) {
  const std::vector<double> spacings = sorted_spacings(request.spacings);
  if (spacings.size() < 2)
    throw InputError(spacing_option, fmt::format("{} given; at least 2", spacings.size()));
  check_formulations(request.formulations);
  std::vector<std::string> formulations = request.formulations;
  if (formulations.empty()) formulations.emplace_back();

  ConvergencePlan plan;
  for (const std::string& formulation : formulations) {
    std::vector<PlannedRun> runs;
    for (const double spacing : spacings) {
      PlannedRun run;
      run.scene = scene_of(request, formulation, spacing);
      if (runs.empty()) check_method(spacings, run.scene);
      run.folder =
          std::filesystem::path(name_of(run.scene.formulation)) / fmt::format("{}", spacing);
      run.scene.dimension == 1 ? divide<1>(run) : divide<2>(run);
      if (!runs.empty() && !(run.spacing < runs.back().spacing * (1.0 - 1e-9)))
        throw InputError(spacing_option,
                         fmt::format("{} divides the body like the spacing before it, into {}; "
                                     "leave one out",
                                     spacing, run.spacing));
      runs.push_back(std::move(run));
    }
    const Scene& coarsest = runs.front().scene;
    coarsest.dimension == 1 ? check_buildable<1>(coarsest) : check_buildable<2>(coarsest);
    plan.method =
        coarsest.exact != ExactKind::none ? ConvergenceMethod::exact : ConvergenceMethod::probes;
    plan.runs.push_back(std::move(runs));
  }
  return plan;
}

}  // namespace tlsph

#include "convergence_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "readings.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

const Place spacing_option{"--spacing", 0, 0, ""};
const Place formulation_option{"--formulation", 0, 0, ""};
const Place seed_option{"--seed", 0, 0, ""};
const Place cloud_option{"--cloud", 0, 0, ""};

template <class T>
void check_once(const Place& option, const std::vector<T>& entries) {
  for (auto entry = entries.begin(); entry != entries.end(); ++entry)
    if (std::find(entries.begin(), entry, *entry) != entry)
      throw InputError(option, fmt::format("{} stands twice; each once", *entry));
}

/// What a series sets beside the sizes of its particles.
struct Choice {
  std::vector<std::string> overrides;
  std::vector<std::string> over;  // values of the compared keys
  std::string keys;               // " key=value" for each of these
};

/// Formulations first, then the other keys in their order; each value with each, the last key turns
/// fastest. A key that a study has an option for is refused.
std::vector<Choice> choices_of(const ConvergenceRequest& request) {
  constexpr std::array<std::pair<const char*, const char*>, 4> options = {
      {{"formulation", "--formulation"},
       {"body.spacing", "--spacing"},
       {"body.seed", "--seed"},
       {"body.cloud", "--cloud"}}};
  check_once(formulation_option, request.formulations);
  check_formulations(request.formulations);
  std::vector<Choice> choices = {{}};
  if (!request.formulations.empty()) choices.clear();
  for (const std::string& name : request.formulations)
    choices.push_back({{"formulation=" + name}, {}, ""});
  std::vector<std::string> keys;
  for (const auto& [key, values] : request.over) {
    const Place place{"--over " + key, 0, 0, ""};
    for (const auto& [name, option] : options)
      if (key == name) throw InputError(place, fmt::format("has an option, {}", option));
    if (std::ranges::find(keys, key) != keys.end())
      throw InputError(place, "stands twice; each key once");
    keys.push_back(key);
    std::vector<Choice> longer;
    for (const Choice& start : choices)
      for (const std::string& value : values) {
        Choice& next = longer.emplace_back(start);
        next.overrides.push_back(key + "=" + value);
        next.over.push_back(value);
        next.keys += " " + next.overrides.back();
      }
    choices = std::move(longer);
  }
  return choices;
}

/// The run of a scene with its spacing and number of particles.
PlannedRun divided(Scene scene) {
  PlannedRun run{std::move(scene), {}, {}};
  in_dimension(run.scene.dimension, [&]<int D>() {
    const Particles<D> particles = build_particles<D>(run.scene);
    run.row.spacing = particles.spacing;
    run.row.particles = particles.size();
  });
  return run;
}

std::filesystem::path stem_of(const std::string& file) {
  return std::filesystem::path(file).stem();
}

/// Plans one series after the other.
class Planner {
 public:
  explicit Planner(const ConvergenceRequest& request)
      : request_(request),
        spacings_(sorted_spacings(request.spacings)),
        choices_(choices_of(request)) {
    const bool clouds = !request.clouds.empty();
    if (clouds && !spacings_.empty())
      throw InputError(cloud_option, "a cloud has its spacing: give --spacing or --cloud");
    if (clouds && !request.seeds.empty())
      throw InputError(seed_option,
                       "a cloud has no seed: give several clouds of equally many particles");
    check_once(seed_option, request.seeds);
    check_once(cloud_option, request.clouds);
    if (!clouds && spacings_.size() < 2)
      throw InputError(spacing_option, fmt::format("{} given; at least 2", spacings_.size()));
  }

  [[nodiscard]] const std::vector<Choice>& choices() const { return choices_; }

  [[nodiscard]] PlannedSeries series(const Choice& choice) const {
    PlannedSeries levels =
        request_.clouds.empty() ? by_spacing(choice.overrides) : by_cloud(choice.overrides);
    const Scene& coarsest = levels.front().front().scene;
    const std::string formulation(name_of(coarsest.formulation));
    std::string folder = formulation + choice.keys;
    std::ranges::replace_if(
        folder, [](char c) { return c == ' ' || c == '/'; }, '_');
    for (auto& level : levels)
      for (PlannedRun& run : level) {
        run.row.series = formulation + choice.keys;
        run.row.formulation = formulation;
        run.row.over = choice.over;
        run.folder = folder / run.folder;
      }
    check_levels(levels.size(), coarsest);
    check_seeds(levels.front());
    check_buildable(coarsest);
    return levels;
  }

 private:
  /// The scene of one run. Frames are of no use to a study, unless the user asks for them; what the
  /// study varies comes last, so that it wins.
  Scene scene_of(const std::vector<std::string>& chosen) const {
    std::vector<std::string> overrides = {"output.frames=0"};
    std::ranges::copy(request_.overrides, std::back_inserter(overrides));
    std::ranges::copy(chosen, std::back_inserter(overrides));
    return read_scene(request_.scene, overrides);
  }

  PlannedSeries by_spacing(const std::vector<std::string>& chosen) const {
    PlannedSeries levels;
    for (const double spacing : spacings_) {
      std::vector<std::string> overrides = chosen;
      overrides.push_back(fmt::format("body.spacing={}", spacing));
      Scene scene = scene_of(overrides);
      if (levels.empty()) check_levels(spacings_.size(), scene);
      PlannedRun run = divided(std::move(scene));
      run.folder = fmt::format("{}", spacing);
      if (!levels.empty() && !(run.row.spacing < levels.back().front().row.spacing * (1.0 - 1e-9)))
        throw InputError(spacing_option,
                         fmt::format("{} divides the body like the spacing before it, into {}; "
                                     "leave one out",
                                     spacing, run.row.spacing));
      levels.push_back(request_.seeds.empty() ? std::vector{run} : seeded(run, overrides));
    }
    return levels;
  }

  std::vector<PlannedRun> seeded(const PlannedRun& run, std::vector<std::string> overrides) const {
    std::vector<PlannedRun> samples(request_.seeds.size(), run);
    overrides.emplace_back();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::string& sample = samples[k].row.sample;
      sample = fmt::format("{}", request_.seeds[k]);
      overrides.back() = "body.seed=" + sample;
      samples[k].scene = scene_of(overrides);
      samples[k].folder /= "seed-" + sample;
    }
    return samples;
  }

  PlannedSeries by_cloud(const std::vector<std::string>& chosen) const {
    std::vector<PlannedRun> runs;
    for (const std::string& cloud : request_.clouds) {
      const auto namesakes = std::ranges::count(
          runs, stem_of(cloud), [](const PlannedRun& other) { return stem_of(other.row.sample); });
      std::vector<std::string> overrides = chosen;
      // Quoted: a path is a text, whatever it looks like.
      overrides.push_back(
          fmt::format("body.cloud='{}'", std::filesystem::absolute(cloud).string()));
      Scene scene = scene_of(overrides);
      scene.body.spacing = 0.0;  // its own, not one for all
      PlannedRun run = divided(std::move(scene));
      run.row.sample = cloud;
      run.folder = stem_of(cloud);
      if (namesakes > 0) run.folder += fmt::format("-{}", namesakes + 1);
      runs.push_back(std::move(run));
    }
    const auto particles = [](const PlannedRun& run) { return run.row.particles; };
    std::ranges::stable_sort(runs, {}, particles);
    PlannedSeries levels;
    for (PlannedRun& run : runs) {
      if (levels.empty() || particles(levels.back().front()) != particles(run))
        levels.emplace_back();
      levels.back().push_back(std::move(run));
    }
    return levels;
  }

  void check_levels(std::size_t levels, const Scene& scene) const {
    const bool exact = scene.exact != ExactKind::none;
    if (!exact && scene.probes.empty())
      throw InputError(
          {scene.file, 0, 0, ""},
          "nothing to compare: neither reference.exact nor a [[probe]]; add one of them");
    check_value_names(request_.values, scene);
    const bool clouds = !request_.clouds.empty();
    const std::size_t least = exact ? 2 : 3;
    if (levels < least)
      throw InputError(clouds ? cloud_option : spacing_option,
                       fmt::format("{} {}; at least {}{}", levels,
                                   clouds ? "different numbers of particles" : "given", least,
                                   exact ? "" : ", as the scene names no exact solution"));
  }

  void check_seeds(const std::vector<PlannedRun>& samples) const {
    if (request_.seeds.size() < 2) return;
    const Scene& a = samples[0].scene;
    const Scene& b = samples[1].scene;
    if (in_dimension(a.dimension,
                     [&]<int D>() { return build_particles<D>(a).X == build_particles<D>(b).X; }))
      throw InputError(seed_option,
                       "the particles do not depend on it; move them, with body.jitter=0.2");
  }

  const ConvergenceRequest& request_;
  std::vector<double> spacings_;
  std::vector<Choice> choices_;
};

}  // namespace

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
  for (const std::string& name : names)
    if (!from_name<Formulation>(name))
      throw InputError(formulation_option, fmt::format("there is no \"{}\"; choose from {}", name,
                                                       choices<Formulation>()));
}

void check_buildable(const Scene& scene) {
  in_dimension(scene.dimension, [&]<int D>() {
    const Discretisation<D> body = build<D>(scene);
    (void)build_initial<D>(scene, body);
    (void)build_exact<D>(scene, body);
    std::vector<ProbeRequest<D>> probes;
    for (const ProbeScene& probe : scene.probes)
      probes.push_back({probe.name, Eigen::Map<const Vector<D>>(probe.at.data()), {}});
    (void)Probes<D>(body, probes);
  });
}

ConvergencePlan plan_convergence(const ConvergenceRequest& request) {
  const Planner planner(request);
  ConvergencePlan plan;
  for (const Choice& choice : planner.choices()) plan.series.push_back(planner.series(choice));
  const auto exact = [](const PlannedSeries& series) {
    return series.front().front().scene.exact != ExactKind::none;
  };
  plan.method = exact(plan.series.front()) ? ConvergenceMethod::exact : ConvergenceMethod::probes;
  for (const PlannedSeries& series : plan.series)
    if (exact(series) != exact(plan.series.front()))
      throw InputError("some series have an exact solution, some have none: one study each");
  return plan;
}

}  // namespace tlsph

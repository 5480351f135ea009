#include "tlsph/studies/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart_plan.hpp"
#include "fit_plan.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

/// Predictions aim below the wanted error by what they may be off.
constexpr double aim = 0.8;
/// An error below this share of the wanted one is more than was asked for.
constexpr double too_good = 0.2;
/// Shares of the wanted error by which a linear law may differ from that of the scene.
constexpr double same_answer = 0.05;
/// Pilots longer than this are replaced by extrapolation: once the order has settled, always [s].
constexpr double long_pilot = 0.5, longest_pilot = 30.0;
/// Spacings at which a family that the coarsest refuses is tried.
constexpr int starts = 6;
/// From one pilot to the next.
constexpr double refinement = 2.0;

class FitStudy {
 public:
  FitStudy(const FitRequest& request, const FitPlan& plan, const FitOptions& options)
      : request_(request), plan_(plan), options_(options) {
    table_.scene = request.scene.string();
    table_.version = version();
    table_.wanted = request.error;
    table_.quantity = plan.quantity;
    table_.reductions = plan.reductions;
    table_.answer = not_known;
    make_output_directory(options.out);
    may_end_at_once() = false;  // from now on an interrupted fit writes what it has found
  }

  FitTable run() {
    find_answer();
    for (const ChartFamily& family : plan_.families) {
      if (stopped()) break;
      table_.families.push_back({family.family, family.overrides, {}, false, 0, 0, 0, 0, ""});
      explore(table_.families.back());
    }
    if (!stopped()) choose_and_verify();
    table_.interrupted = stopped();
    table_.spent = watch_.seconds();
    table_.write(options_.out);
    return table_;
  }

 private:
  [[nodiscard]] bool stopped() const { return options_.stopped(); }

  void find_answer() {
    if (!request_.value) return;
    table_.answer =
        find_answers(plan_.study, plan_.study.spacings.front(), options_, options_.threads, [&] {
          show("extrapolating the answer");
        }).front();
  }

  void show(const std::string& what) const {
    if (options_.progress)
      options_.progress(what, static_cast<double>(table_.families.size()) /
                                  static_cast<double>(plan_.families.size() + 1));
  }

  [[nodiscard]] Scene scene_of(const std::vector<std::string>& overrides, double spacing) const {
    std::vector<std::string> all = overrides;
    all.push_back(fmt::format("body.spacing={:.17g}", spacing));
    return read_scene_text(plan_.scene.text, plan_.scene.file, all);
  }

  std::optional<Pilot> measure(const Scene& scene, const std::string& what) const {
    return run_pilot(request_, table_.answer, scene, options_, [&] { show(what); });
  }

  /// From the coarsest spacing on to one that meets the error, or to where that is hopeless.
  void explore(FitFamily& family) {
    std::optional<Scene> scene;
    try {
      scene = scene_of(family.overrides, 1.0);
    } catch (const InputError&) {
      family.note = "refused";
      return;
    }
    int tries = 0;
    double spacing = next_division(*scene, std::numeric_limits<double>::infinity());
    while (!stopped()) {
      try {
        scene = scene_of(family.overrides, spacing);
        const std::optional<Pilot> pilot =
            measure(*scene, fmt::format("{} at {:.4g} m", family.label, spacing));
        if (!pilot) return;
        // Before there is something to see, e.g. a period, is before the first pilot.
        if (std::isfinite(pilot->error))
          family.pilots.push_back(*pilot);
        else if (!family.pilots.empty())
          family.note = "no answer at a finer spacing";
      } catch (const InputError&) {
        if (!family.pilots.empty()) family.note = "refused at a finer spacing";
      } catch (const NumericalError&) {
        if (!family.pilots.empty()) family.note = "failed";
      }
      if (family.pilots.empty() && ++tries == starts) family.note = "refused";
      if (!family.note.empty() || (!family.pilots.empty() && is_done(family))) return;
      spacing = next_division(*scene, spacing / refinement);
      if (spacing <= 0.0) return;
    }
  }

  /// Concludes, if there is nothing to be learnt from a finer pilot.
  bool is_done(FitFamily& family) {
    const std::vector<Pilot>& pilots = family.pilots;
    const double target = aim * table_.wanted;
    const double next =
        predicted_seconds(pilots, pilots.back().spacing / refinement, plan_.scene.dimension);
    // Where the finest has met the error, a finer one is to tell whether that was luck.
    const bool meets = std::abs(pilots.back().error) <= target;
    if (is_bracketed(pilots, target))
      conclude(family);
    else if (hoped_seconds(pilots, target, plan_.scene.dimension) > best_seconds() ||
             (!meets && next > best_seconds()))
      family.note = "dearer";
    else if (has_stalled(pilots))
      family.note = "stalls";
    else if (next > longest_pilot || (next > long_pilot && has_settled(pilots)))
      conclude(family);
    else
      return false;
    return true;
  }

  void conclude(FitFamily& family) const {
    tlsph::conclude(family, aim * table_.wanted,
                    scene_of(family.overrides, family.pilots.back().spacing));
  }

  /// Of the families that reach the error; nullptr if none does.
  [[nodiscard]] FitFamily* cheapest() {
    FitFamily* best = nullptr;
    for (FitFamily& family : table_.families)
      if (family.reaches && (best == nullptr || family.predicted_seconds < best->predicted_seconds))
        best = &family;
    return best;
  }

  [[nodiscard]] double best_seconds() {
    const FitFamily* best = cheapest();
    return best != nullptr ? best->predicted_seconds : std::numeric_limits<double>::infinity();
  }

  void choose_and_verify() {
    FitFamily* best = cheapest();
    table_.reached = best != nullptr;
    if (best == nullptr) best = nearest();
    if (best == nullptr)
      throw InputError({plan_.scene.file, 0, 0, ""},
                       "no formulation could be run at any of its coarsest spacings; try "
                       "tlsph run to see why");
    std::vector<std::string> overrides = best->overrides;
    const double law_time = use_linear_law(*best, overrides);
    if (stopped()) return;
    write_choice(*best, overrides, law_time);
    if (options_.after_choice) options_.after_choice(table_);
    if (!verify(*best) || !missed() || !table_.reached) return;
    // Once more, with what this one has shown.
    table_.first_error = table_.measured_error;
    const double before = table_.spacing;
    conclude(*best);
    if (!best->reaches || best->spacing == before) return;
    table_.corrected = true;
    write_choice(*best, overrides, law_time);
    (void)verify(*best);
  }

  /// Where none reaches the error: the family that came nearest, at its best pilot.
  FitFamily* nearest() {
    FitFamily* best = nullptr;
    for (FitFamily& family : table_.families)
      for (const Pilot& pilot : family.pilots) {
        if (best != nullptr && best->predicted_error <= std::abs(pilot.error)) continue;
        best = &family;
        family.spacing = pilot.spacing;
        family.predicted_error = std::abs(pilot.error);
        family.predicted_seconds = pilot.charged;
      }
    return best;
  }

  /// Share of the time that a linear law takes; 1 where the law of the scene stays. It is tried at
  /// the pilot nearest to the choice.
  double use_linear_law(const FitFamily& family, std::vector<std::string>& overrides) {
    if (plan_.linear.empty()) return 1.0;
    const Pilot& pilot = *std::ranges::min_element(family.pilots, {}, [&](const Pilot& p) {
      return std::abs(std::log(p.spacing / family.spacing));
    });
    std::vector<std::string> linear = overrides;
    linear.insert(linear.end(), plan_.linear.begin(), plan_.linear.end());
    try {
      const auto run = measure(scene_of(linear, pilot.spacing), family.label + ", linear elastic");
      if (!run || !(std::abs(run->error - pilot.error) <= same_answer * table_.wanted)) return 1.0;
      table_.linear = true;
      overrides = linear;
      return std::min(1.0, run->charged / pilot.charged);
    } catch (const NumericalError&) {
      return 1.0;
    }
  }

  void write_choice(const FitFamily& family, const std::vector<std::string>& overrides,
                    double law_time) {
    const Scene scene = scene_of(overrides, family.spacing);
    table_.family = family.label;
    table_.text = scene.text;
    table_.spacing = family.spacing;
    table_.predicted_error = family.predicted_error;
    table_.predicted_seconds = law_time * family.predicted_seconds;
    table_.coarsest = family.spacing >= family.pilots.front().spacing;
    write_text_file(options_.out / "scene.toml",
                    fmt::format("# {} = {:.3g} at the error of {:.3g} that was wanted, for {}.\n{}",
                                table_.quantity, table_.predicted_error, table_.wanted,
                                table_.scene, table_.text));
  }

  /// One run of the file that was written; a pilot more. False if it was interrupted.
  bool verify(FitFamily& family) {
    const Scene scene = read_scene(options_.out / "scene.toml");
    const auto pilot = measure(scene, "verifying");
    if (!pilot) return false;
    table_.particles = pilot->particles;
    table_.steps = pilot->steps;
    table_.measured_error = std::abs(pilot->error);
    table_.measured_seconds = pilot->charged;
    const auto place = std::ranges::find_if(
        family.pilots, [&](const Pilot& p) { return p.spacing <= pilot->spacing * (1.0 + 1e-9); });
    if (place != family.pilots.end() && place->spacing >= pilot->spacing * (1.0 - 1e-9))
      place->error = pilot->error;
    else
      family.pilots.insert(place, *pilot);
    return true;
  }

  [[nodiscard]] bool missed() const {
    return !table_.meets() ||
           (table_.measured_error < too_good * table_.wanted && !table_.coarsest);
  }

  const FitRequest& request_;
  const FitPlan& plan_;
  const FitOptions& options_;
  const Stopwatch watch_;
  FitTable table_;
};

}  // namespace

FitTable fit(const FitRequest& request, const FitOptions& options) {
  const FitPlan plan = plan_fit(request);
  return removed_if_refused(options.out, [&] { return FitStudy(request, plan, options).run(); });
}

}  // namespace tlsph

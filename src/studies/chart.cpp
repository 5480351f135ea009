#include "tlsph/studies/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart_plan.hpp"
#include "peers.hpp"
#include "readings.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/version.hpp"
#include "tlsph/studies/chart_search.hpp"

namespace tlsph {
namespace {

/// Parts of the budget: peers, when there are any; a first look at every family; the front's times
/// once more.
constexpr double peer_share = 0.3, screening_share = 0.35, repetition_share = 0.12;
/// What a prediction may err by before a family is given up.
constexpr double margin = 1.25;
/// So near to the front, in time and error, variants of a family are tried; one of them may have so
/// much less of its error: half the step at second order, or errors that cancel.
constexpr double near_front = 1.1, variant_hope = 4.0;
/// A run shorter than this is repeated at once: its time is noise.
constexpr double short_run = 0.02;  // [s]
constexpr std::size_t first_repetitions = 3, repetitions = 5;
/// Finer spacings at which a family is tried that the coarsest does not allow.
constexpr std::size_t later_starts = 2;

/// A family and its runs from spacing to spacing.
struct Contender {
  ChartFamily family;
  std::vector<Measured> runs;
  std::optional<Predicted> expected;  ///< of its first run, of a variant
  std::size_t next = 0;               ///< rung to come
  std::size_t first = 0;              ///< rung of its first run
  bool out = false;                   ///< refused or failed
  bool varied = false;                ///< its variants are contenders
};

class ChartSearch {
 public:
  ChartSearch(const ChartRequest& request, const ChartPlan& plan, const ChartOptions& options)
      : study_{request, plan, options} {
    table_.scene = plan.scene.file;
    table_.version = version();
    table_.budget = request.budget;
    table_.threads = options.threads;
    table_.quantities = plan.quantities;
    table_.answers = plan.answers;
    for (ChartFamily& family : chart_families(plan.scene.dimension, request.formulations)) {
      if (!plan.scene.time.step) family.step_share = plan.scene.time.safety;
      contenders_.push_back({.family = std::move(family), .runs = {}, .expected = {}});
    }
    table_.families = static_cast<int>(contenders_.size());
    make_output_directory(options.out);
  }

  ChartTable run() {
    const ChartRequest& request = study_.request;
    const std::vector<double> answers =
        find_answers(request, plan_.scene.body.spacing, study_.options, study_.options.threads,
                     [&] { study_.show("extrapolating the answer"); });
    std::ranges::copy(answers, table_.answers.end() - std::ssize(answers));
    run_peers(study_, spent() + peer_share * request.budget);
    const double start = spent();
    const double searching = request.budget * (1.0 - repetition_share) - start;
    screen(start + screening_share * searching);
    refine(start + searching);
    repeat_front();
    table_.interrupted = stopped();
    study_.write();
    return table_;
  }

 private:
  [[nodiscard]] double spent() const { return study_.spent(); }
  [[nodiscard]] bool stopped() const { return study_.options.stopped(); }

  /// Every family at the coarsest spacing it can be built at.
  void screen(double until) {
    for (Contender& contender : contenders_) {
      if (stopped() || spent() > until) return;
      const std::size_t last = std::min(later_starts + 1, plan_.ladder.size());
      while (contender.next < last && !advance(contender, until)) continue;
      if (!contender.runs.empty() || contender.out) continue;
      contender.out = true;
      if (!stopped() && spent() < until) ++table_.refused;  // else there was no time to see
    }
  }

  /// The most promising refinement or variant, until nothing promises anything or the time is over.
  void refine(double until) {
    while (!stopped()) {
      std::vector<Measured> all;
      std::vector<std::vector<Measured>> fair;
      for (const Contender& contender : contenders_) {
        fair.push_back(judged(contender.runs, table_.single_numbers()));
        all.insert(all.end(), fair.back().begin(), fair.back().end());
      }
      for (std::size_t k = 0; k < fair.size(); ++k) vary(k, fair[k], all);
      std::vector<Prospect> prospects;
      table_.dominated = 0;
      for (const Contender& contender : contenders_) {
        prospects.emplace_back();
        if (contender.out || contender.next >= plan_.ladder.size()) continue;
        if (contender.runs.empty() && !contender.expected) continue;
        const Predicted run =
            contender.expected
                ? *contender.expected
                : predict(contender.runs, plan_.ladder[contender.next], plan_.scene.dimension);
        prospects.back() = {promise(run, all, margin), run.cost()};
        table_.dominated += prospects.back().promise > 0.0 ? 0 : 1;
      }
      const std::optional<std::size_t> best = best_prospect(prospects, until - spent());
      if (!best) return;
      contenders_[*best].expected.reset();
      (void)advance(contenders_[*best], study_.request.budget);
    }
  }

  /// Makes contenders of the variants of a family whose last run that counts is on the front of
  /// `all`, or nearly; they begin where it began.
  void vary(std::size_t index, const std::vector<Measured>& fair,
            const std::vector<Measured>& all) {
    if (contenders_[index].varied || contenders_[index].out) return;
    const auto near = [&](const Measured& run) {
      return promise({run.setup, run.stepping, run.errors}, all, near_front) > 0.0;
    };
    if (std::ranges::none_of(fair, near)) return;
    contenders_[index].varied = true;
    for (ChartFamily& family : neighbours(contenders_[index].family, study_.variation)) {
      const Contender& parent = contenders_[index];
      Predicted expected{fair.front().setup, fair.front().stepping, fair.front().errors};
      if (family.step_share) expected.stepping *= *parent.family.step_share / *family.step_share;
      for (double& error : expected.errors) error /= variant_hope;
      const std::size_t first = parent.first;
      const auto is_it = [&](const Contender& other) {
        return other.family.family == family.family;
      };
      if (const auto it = std::ranges::find_if(contenders_, is_it); it != contenders_.end()) {
        if (!it->expected || it->first != first) continue;
        for (std::size_t q = 0; q < expected.errors.size(); ++q)  // what the best parent promises
          it->expected->errors[q] = std::min(it->expected->errors[q], expected.errors[q]);
        continue;
      }
      contenders_.push_back({.family = std::move(family),
                             .runs = {},
                             .expected = std::move(expected),
                             .next = first,
                             .first = first});
      ++table_.variants;
    }
  }

  /// Runs a family at its next spacing. False if the scene does not allow that one.
  bool advance(Contender& contender, double until) {
    if (contender.runs.empty()) contender.first = contender.next;
    const double spacing = plan_.ladder[contender.next++];
    const ChartVariation& variation = study_.variation;
    ChartPoint point;
    static_cast<ChartModel&>(point) = contender.family;
    std::ranges::copy(variation.overrides(contender.family), std::back_inserter(point.overrides));
    point.overrides.push_back(fmt::format("body.spacing={}", spacing));
    point.law = variation.law_of(contender.family);
    point.spacing = spacing;
    try {
      if (!time_once(point, until)) return true;  // not to its end: no point
      while (point.seconds.size() < first_repetitions && point.time() < short_run)
        if (!time_once(point, until)) break;
    } catch (const InputError&) {
      return false;
    } catch (const NumericalError& failure) {
      point.failure = failure.what();
      point.errors.assign(table_.quantities.size(), not_known);
      contender.out = true;
    }
    if (!contender.out)
      contender.runs.push_back({spacing, point.setup_seconds, point.time(), point.errors});
    study_.add(std::move(point));
    return true;
  }

  /// One run of a point, its time added. False if it did not come to its end in time.
  bool time_once(ChartPoint& point, double until) {
    const std::string what = fmt::format("{} at {:.4g} m", point.family, point.spacing);
    study_.show(what);
    std::vector<std::string> overrides = {"output.frames=0"};
    std::ranges::copy(study_.request.overrides, std::back_inserter(overrides));
    std::ranges::copy(point.overrides, std::back_inserter(overrides));
    std::atomic<bool> stop{false};
    RunOptions options;
    options.threads = study_.options.threads;
    options.stop_requested = &stop;
    options.progress = [&](const Progress&) {
      study_.show(what);
      if (stopped() || spent() > until) stop = true;
    };
    const auto run =
        run_probed(read_scene(study_.request.scene, overrides), options, !plan_.values.empty());
    if (!run) return false;
    const Summary& summary = run->summary;
    if (point.seconds.empty()) {
      point.particles = summary.particles;
      point.steps = summary.steps;
      point.setup_seconds = summary.wall_setup;
      point.errors = errors_of(summary);
      for (const double value : read_values(plan_.values, run->history))
        point.errors.push_back(std::abs(value / table_.answers[point.errors.size()] - 1.0));
    }
    point.seconds.push_back(summary.wall_stepping);
    return true;
  }

  void repeat_front() {
    for (std::size_t round = 1; round < repetitions; ++round) {
      table_.mark_fronts();
      for (ChartPoint& point : table_.points) {
        const bool wanted = std::ranges::find(point.front, true) != point.front.end() &&
                            point.peer.empty() && point.seconds.size() <= round;
        const double cost = point.setup_seconds + point.time();
        if (stopped()) return;
        const double budget = study_.request.budget;
        if (wanted && spent() + cost < budget) (void)time_once(point, budget);
      }
    }
  }

  ChartStudy study_;
  const ChartPlan& plan_ = study_.plan;
  ChartTable& table_ = study_.table;
  std::vector<Contender> contenders_;
};

}  // namespace

ChartTable chart(const ChartRequest& request, const ChartOptions& options) {
  const ChartPlan plan = plan_chart(request);
  return removed_if_refused(options.out, [&] { return ChartSearch(request, plan, options).run(); });
}

}  // namespace tlsph

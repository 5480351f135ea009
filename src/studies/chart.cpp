#include "tlsph/studies/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart_answers.hpp"
#include "chart_families.hpp"
#include "chart_peers.hpp"
#include "chart_plan.hpp"
#include "chart_variants.hpp"
#include "probe_values.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stopwatch.hpp"
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

/// A family on its way down the ladder.
struct Contender {
  ChartFamily family;
  std::vector<Measured> runs;
  std::optional<Predicted> expected;  ///< of its first run, of a variant
  std::size_t next = 0;               ///< rung to come
  std::size_t first = 0;              ///< rung of its first run
  bool out = false;                   ///< refused or failed
  bool varied = false;                ///< its variants are contenders
};

class ChartStudy {
 public:
  ChartStudy(const ChartRequest& request, const ChartPlan& plan, const ChartOptions& options)
      : request_(request), plan_(plan), options_(options), variation_(chart_variation(plan.scene)) {
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
    const std::vector<double> answers =
        find_answers(request_, plan_.scene.body.spacing, options_, options_.threads,
                     [&] { show("extrapolating the answer"); });
    std::ranges::copy(answers, table_.answers.end() - std::ssize(answers));
    const double peers_until = spent() + peer_share * request_.budget;
    ChartPeers{request_,
               plan_,
               variation_,
               options_,
               table_,
               [&] { return spent(); },
               [&](const std::string& what) { show(what); },
               [&](ChartPoint point) { add(std::move(point)); }}
        .run(peers_until);
    const double start = spent();
    const double searching = request_.budget * (1.0 - repetition_share) - start;
    screen(start + screening_share * searching);
    refine(start + searching);
    repeat_front();
    table_.interrupted = stopped();
    write();
    return table_;
  }

 private:
  [[nodiscard]] double spent() const { return watch_.seconds(); }
  [[nodiscard]] bool stopped() const { return options_.stopped(); }
  void show(const std::string& what) const {
    if (options_.progress) options_.progress(what, std::min(1.0, spent() / request_.budget));
  }

  /// Every family at the coarsest spacing it can be built at.
  void screen(double until) {
    for (Contender& contender : contenders_) {
      if (stopped() || spent() > until) return;
      const std::size_t last = std::min(later_starts + 1, plan_.ladder.size());
      while (contender.next < last && !advance(contender, until)) {
      }
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
      (void)advance(contenders_[*best], request_.budget);
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
    for (ChartFamily& family : neighbours(contenders_[index].family, variation_)) {
      const Contender& parent = contenders_[index];
      Predicted expected{fair.front().setup, fair.front().stepping, fair.front().errors};
      if (family.step_share) expected.stepping *= *parent.family.step_share / *family.step_share;
      for (double& error : expected.errors) error /= variant_hope;
      const std::size_t first = parent.first;
      const auto is_it = [&](const Contender& other) { return other.family.label == family.label; };
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
    ChartPoint point;
    point.family = contender.family.label;
    point.overrides = contender.family.overrides;
    std::ranges::copy(variation_.overrides(contender.family), std::back_inserter(point.overrides));
    point.overrides.push_back(fmt::format("body.spacing={}", spacing));
    point.formulation = contender.family.formulation;
    point.kernel = contender.family.kernel;
    point.stabiliser = contender.family.stabiliser;
    point.support = contender.family.support;
    point.order = contender.family.order;
    point.law = variation_.law_of(contender.family);
    point.step_share = contender.family.step_share;
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
    add(std::move(point));
    return true;
  }

  /// One run of a point, its time added. False if it did not come to its end in time.
  bool time_once(ChartPoint& point, double until) {
    show(fmt::format("{} at {:.4g} m", point.family, point.spacing));
    std::vector<std::string> overrides = {"output.frames=0"};
    overrides.insert(overrides.end(), request_.overrides.begin(), request_.overrides.end());
    overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
    std::atomic<bool> stop{false};
    RunOptions run_options;
    run_options.threads = options_.threads;
    run_options.stop_requested = &stop;
    run_options.progress = [&](const Progress&) {
      show(fmt::format("{} at {:.4g} m", point.family, point.spacing));
      if (stopped() || spent() > until) stop = true;
    };
    ProbeHistories histories;
    if (!plan_.values.empty()) run_options.histories = &histories;
    const Summary summary = tlsph::run(read_scene(request_.scene, overrides), run_options);
    if (summary.interrupted) return false;
    if (point.seconds.empty()) {
      point.particles = summary.particles;
      point.steps = summary.steps;
      point.setup_seconds = summary.wall_setup;
      point.errors = errors_of(summary, histories.computed);
    }
    point.seconds.push_back(summary.wall_stepping);
    return true;
  }

  [[nodiscard]] std::vector<double> errors_of(const Summary& summary,
                                              const History& history) const {
    std::vector<double> errors;
    if (summary.errors)
      errors = {summary.errors->displacement, summary.errors->velocity, summary.errors->stress};
    if (plan_.values.empty()) return errors;
    for (const double value : read_values(plan_.values, history))
      errors.push_back(std::abs(value / table_.answers[errors.size()] - 1.0));
    return errors;
  }

  void repeat_front() {
    for (std::size_t round = 1; round < repetitions; ++round) {
      table_.mark_fronts();
      for (ChartPoint& point : table_.points) {
        const bool wanted = std::ranges::find(point.front, true) != point.front.end() &&
                            point.peer.empty() && point.seconds.size() <= round;
        const double cost = point.setup_seconds + point.time();
        if (stopped()) return;
        if (wanted && spent() + cost < request_.budget) (void)time_once(point, request_.budget);
      }
    }
  }

  void add(ChartPoint point) {
    table_.points.push_back(std::move(point));
    if (options_.after_point)
      options_.after_point(table_.points.back(), std::min(1.0, spent() / request_.budget));
    // Now and then, for whom the rest does not come.
    if (table_.points.size() % 20 == 0) write();
  }

  void write() {
    table_.spent = spent();
    table_.mark_fronts();
    table_.write(options_.out);
  }

  const ChartRequest& request_;
  const ChartPlan& plan_;
  const ChartOptions& options_;
  const ChartVariation variation_;
  const Stopwatch watch_;
  ChartTable table_;
  std::vector<Contender> contenders_;
};

}  // namespace

ChartTable chart(const ChartRequest& request, const ChartOptions& options) {
  const ChartPlan plan = plan_chart(request);
  return removed_if_refused(options.out, [&] { return ChartStudy(request, plan, options).run(); });
}

}  // namespace tlsph

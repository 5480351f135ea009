#include "tlsph/studies/converge.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "convergence_plan.hpp"
#include "readings.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

/// The study as it goes: one series after the other, each from coarse to fine.
class Study {
 public:
  Study(const ConvergenceRequest& request, const ConvergencePlan& plan,
        const ConvergenceOptions& options)
      : plan_(plan), options_(options) {
    const PlannedRun& first = plan.series.front().front().front();
    table_.scene = first.scene.file;
    table_.version = version();
    table_.method = plan.method;
    table_.quantities = by_probes() ? recorded_quantities(first.scene) : error_field_names();
    for (const Variation& variation : request.over) table_.over.push_back(variation.key);
    if (!request.clouds.empty()) table_.sample_key = "body.cloud";
    if (!request.seeds.empty()) table_.sample_key = "body.seed";
    table_.value_names = request.values;
    choose_values_ = request.values.empty() && by_probes();
    keeps_probes_ = by_probes() || !request.values.empty();
    if (options.out.empty() && keeps_probes_)
      throw InputError(
          "a study that reads the probes compares histories on disk: name a directory");
    if (!options.out.empty()) make_output_directory(options.out);
  }

  ConvergenceTable run() {
    for (const PlannedSeries& series : plan_.series) {
      start_series();
      for (const std::vector<PlannedRun>& level : series) {
        table_.interrupted = !std::ranges::all_of(
            level, [&](const PlannedRun& planned) { return add_row(planned); });
        conclude();
        write();
        if (table_.interrupted) break;
      }
      if (table_.interrupted) break;
      extrapolate(series);
    }
    write();
    return table_;
  }

 private:
  [[nodiscard]] bool by_probes() const { return plan_.method == ConvergenceMethod::probes; }

  void start_series() {
    first_row_ = table_.rows.size();
    first_level_ = table_.levels.size();
    first_fit_ = table_.fits.size();
    first_value_ = table_.values.size();
    histories_.clear();
  }

  /// False if a signal stopped the run before its end.
  bool add_row(const PlannedRun& planned) {
    ConvergenceRow row = planned.row;
    row.dt = row.wall_seconds = not_known;
    row.errors.assign(table_.quantities.size(), not_known);
    row.orders = row.errors;
    if (options_.before_run) options_.before_run(row);
    RunOptions run_options;
    run_options.threads = options_.threads;
    run_options.progress = options_.run_progress;
    run_options.stop_requested = options_.stop_requested;
    if (keeps_probes_) run_options.out = options_.out / planned.folder;
    std::optional<History> history;
    try {
      auto run = run_probed(planned.scene, run_options, keeps_probes_);
      if (!run) return false;
      const Summary& summary = run->summary;
      row.steps = summary.steps;
      row.dt = summary.dt;
      row.wall_seconds = summary.wall_setup + summary.wall_stepping;
      if (summary.errors) row.errors = errors_of(summary);
      if (keeps_probes_) history = std::move(run->history);
    } catch (const NumericalError& failure) {
      row.failure = failure.what();
    }
    table_.rows.push_back(row);
    histories_.push_back(std::move(history));
    if (options_.after_run) options_.after_run(row);
    return true;
  }

  [[nodiscard]] std::span<ConvergenceRow> rows() {
    return std::span(table_.rows).subspan(first_row_);
  }

  /// Differences of the probes between levels, a sample at a time: from the run of the same seed at
  /// the next finer spacing at which any run reached its end.
  void compare_probes() {
    std::vector<std::string> samples;
    for (const ConvergenceRow& row : rows())
      if (std::ranges::find(samples, row.sample) == samples.end()) samples.push_back(row.sample);
    // Clouds differ from level to level: the first stands for its level.
    const bool paired = table_.sample_key != "body.cloud";
    if (!paired) samples.resize(1);
    std::vector<Index> ended;  // particles of levels, coarse to fine
    for (std::size_t k = 0; k < rows().size(); ++k)
      if (histories_[k] && (ended.empty() || ended.back() != rows()[k].particles))
        ended.push_back(rows()[k].particles);
    for (const std::string& sample : samples) {
      std::vector<std::size_t> chain;
      for (std::size_t k = 0; k < rows().size(); ++k) {
        const bool next_level =
            chain.empty() || rows()[k].particles != rows()[chain.back()].particles;
        if (histories_[k] && next_level && (!paired || rows()[k].sample == sample))
          chain.push_back(k);
      }
      std::vector<History> chained;
      for (const std::size_t k : chain) chained.push_back(*histories_[k]);
      const auto differences = probe_differences(table_.quantities, chained);
      for (std::size_t k = 0; k < chain.size(); ++k) {
        const auto next = std::ranges::upper_bound(ended, rows()[chain[k]].particles);
        const bool neighbours =
            k + 1 < chain.size() && next != ended.end() && rows()[chain[k + 1]].particles == *next;
        for (std::size_t q = 0; q < differences.size(); ++q)
          rows()[chain[k]].errors[q] = neighbours ? differences[q][k] : not_known;
      }
    }
  }

  /// What the rows of this series show so far, in place of what they showed before.
  void conclude() {
    if (by_probes()) compare_probes();
    table_.levels.resize(first_level_);
    table_.fits.resize(first_fit_);
    table_.values.resize(first_value_);
    SeriesOrders found = find_orders(rows(), table_.quantities, plan_.method);
    std::size_t row = 0;
    for (const ConvergenceLevel& level : found.levels) {
      if (level.runs == 1) rows()[row].orders = level.median_orders;
      row += static_cast<std::size_t>(level.runs);
    }
    std::ranges::move(found.levels, std::back_inserter(table_.levels));
    std::ranges::move(found.fits, std::back_inserter(table_.fits));
    if (keeps_probes_) read_probes();
  }

  void read_probes() {
    if (choose_values_)
      for (const std::optional<History>& history : histories_)
        if (history)
          for (const std::string& name : telling_values(*history))
            if (std::ranges::find(table_.value_names, name) == table_.value_names.end())
              table_.value_names.push_back(name);
    for (std::size_t k = 0; k < rows().size(); ++k)
      if (histories_[k]) rows()[k].values = read_values(table_.value_names, *histories_[k]);
    std::ranges::move(find_limits(rows(), table_.value_names), std::back_inserter(table_.values));
  }

  /// Beside the runs of the series, what their histories tend to. Samples scatter: none then.
  void extrapolate(const PlannedSeries& series) {
    if (!by_probes() || !table_.sample_key.empty()) return;
    std::vector<std::size_t> done;
    for (std::size_t k = 0; k < rows().size(); ++k)
      if (histories_[k]) done.push_back(k);
    if (done.size() < 3) return;
    const std::size_t coarse = done[done.size() - 2];
    const std::size_t fine = done.back();
    std::vector<double> orders;
    for (std::size_t k = first_fit_; k < table_.fits.size(); ++k)
      orders.push_back(table_.fits[k].fit.order);
    const History limit =
        extrapolated(*histories_[coarse], *histories_[fine],
                     rows()[coarse].spacing / rows()[fine].spacing, table_.quantities, orders);
    const std::filesystem::path folder = series.front().front().folder.parent_path();
    if (!limit.names.empty())
      write_history(options_.out / folder / "probes_extrapolated.csv", limit);
  }

  void write() const {
    if (!options_.out.empty()) table_.write(options_.out);
  }

  const ConvergencePlan& plan_;
  const ConvergenceOptions& options_;
  ConvergenceTable table_;
  bool choose_values_ = false, keeps_probes_ = false;
  std::size_t first_row_ = 0, first_level_ = 0, first_fit_ = 0, first_value_ = 0;  // of the series
  std::vector<std::optional<History>> histories_;  // of its rows; empty where a run failed
};

}  // namespace

ConvergenceTable converge(const ConvergenceRequest& request, const ConvergenceOptions& options) {
  const ConvergencePlan plan = plan_convergence(request);
  return removed_if_refused(options.out, [&] { return Study(request, plan, options).run(); });
}

}  // namespace tlsph

#include "tlsph/studies/converge.hpp"

#include <cmath>

#include "convergence_plan.hpp"
#include "probe_differences.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The study as it goes: one formulation after the other, each from coarse to fine.
class Study {
 public:
  Study(const ConvergencePlan& plan, const ConvergenceOptions& options)
      : plan_(plan), options_(options) {
    const Scene& first = plan.runs.front().front().scene;
    table_.scene = first.file;
    table_.version = version();
    table_.method = plan.method;
    table_.quantities = plan.method == ConvergenceMethod::exact
                            ? std::vector<std::string>{"displacement", "velocity", "stress"}
                            : recorded_quantities(first);
    if (!options.out.empty()) make_output_directory(options.out);
  }

  ConvergenceTable run() {
    for (const std::vector<PlannedRun>& runs : plan_.runs) {
      const std::size_t first = table_.rows.size();
      const std::size_t fits = table_.fits.size();
      histories_.clear();
      for (const PlannedRun& planned : runs) {
        if (!add_row(planned)) {
          table_.interrupted = true;
          break;
        }
        if (plan_.method == ConvergenceMethod::probes) compare_probes(first);
        table_.fits.resize(fits);
        find_orders(first);
        write();
      }
      if (table_.interrupted) break;
    }
    write();
    return table_;
  }

 private:
  /// False if a signal stopped the run before its end.
  bool add_row(const PlannedRun& planned) {
    ConvergenceRow row;
    row.formulation = name_of(planned.scene.formulation);
    row.spacing = planned.spacing;
    row.particles = planned.particles;
    row.dt = row.wall_seconds = unknown;
    row.errors.assign(table_.quantities.size(), unknown);
    row.orders = row.errors;
    if (options_.before_run) options_.before_run(row);
    RunOptions run_options;
    run_options.threads = options_.threads;
    run_options.progress = options_.progress;
    run_options.stop_requested = options_.stop_requested;
    if (plan_.method == ConvergenceMethod::probes) run_options.out = options_.out / planned.folder;
    try {
      const Summary summary = tlsph::run(planned.scene, run_options);
      if (summary.interrupted) return false;
      row.steps = summary.steps;
      row.dt = summary.dt;
      row.wall_seconds = summary.wall_setup + summary.wall_stepping;
      if (summary.errors)
        row.errors = {summary.errors->displacement, summary.errors->velocity,
                      summary.errors->stress};
      if (plan_.method == ConvergenceMethod::probes)
        histories_.push_back(read_history(run_options.out / "probes.csv"));
    } catch (const NumericalError& failure) {
      row.failure = failure.what();
    }
    table_.rows.push_back(row);
    if (options_.after_run) options_.after_run(row);
    return true;
  }

  /// Rows from `first` on whose runs came to their end.
  std::vector<ConvergenceRow*> completed(std::size_t first) {
    std::vector<ConvergenceRow*> rows;
    for (std::size_t k = first; k < table_.rows.size(); ++k)
      if (table_.rows[k].failure.empty()) rows.push_back(&table_.rows[k]);
    return rows;
  }

  void compare_probes(std::size_t first) {
    const auto rows = completed(first);
    const auto differences = probe_differences(table_.quantities, histories_);
    for (std::size_t k = 0; k < rows.size(); ++k)
      for (std::size_t q = 0; q < differences.size(); ++q)
        rows[k]->errors[q] = k < differences[q].size() ? differences[q][k] : unknown;
  }

  void find_orders(std::size_t first) {
    const auto rows = completed(first);
    if (rows.empty()) return;
    std::vector<double> spacings;
    for (const ConvergenceRow* row : rows) spacings.push_back(row->spacing);
    for (std::size_t q = 0; q < table_.quantities.size(); ++q) {
      std::vector<double> errors;
      for (const ConvergenceRow* row : rows) errors.push_back(row->errors[q]);
      ConvergenceFit entry{rows.front()->formulation, table_.quantities[q], {}, unknown};
      std::vector<double> orders;
      if (plan_.method == ConvergenceMethod::exact) {
        orders = pairwise_orders(spacings, errors);
        entry.fit = fit_order(spacings, errors);
      } else {
        errors.pop_back();
        orders = pairwise_orders_of_differences(spacings, errors);
        entry.fit = fit_order_of_differences(spacings, errors);
        if (rows.size() > 1)
          entry.finest_error = richardson_error(
              errors.back(), spacings[spacings.size() - 2] / spacings.back(), entry.fit.order);
      }
      for (std::size_t k = 0; k < rows.size(); ++k) rows[k]->orders[q] = orders[k];
      table_.fits.push_back(entry);
    }
  }

  void write() const {
    if (!options_.out.empty()) table_.write(options_.out);
  }

  const ConvergencePlan& plan_;
  const ConvergenceOptions& options_;
  ConvergenceTable table_;
  std::vector<History> histories_;  // of the formulation that is running
};

}  // namespace

ConvergenceTable converge(const ConvergenceRequest& request, const ConvergenceOptions& options) {
  const ConvergencePlan plan = plan_convergence(request);
  if (options.out.empty() && plan.method == ConvergenceMethod::probes)
    throw InputError(
        "a study without an exact solution compares histories on disk: name a directory");
  return Study(plan, options).run();
}

}  // namespace tlsph

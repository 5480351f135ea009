#pragma once
/// \file
/// How fast a scene's answer settles as the spacing falls: one run a spacing and formulation, the
/// errors of each, and the orders they fall with.

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tlsph/analysis/order.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {

struct ConvergenceRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;     ///< key=value, as for a run
  std::vector<double> spacings;           ///< [m], in any order
  std::vector<std::string> formulations;  ///< empty: the scene's
};

/// What the errors of a row are taken against.
enum class ConvergenceMethod {
  exact,  ///< the scene's exact solution, fields at the end time: `errors` of the run's summary
  /// No exact solution: for each recorded quantity, the relative L2 norm in time, over all probes
  /// and components, of the difference from the run of the next finer spacing, on the time steps of
  /// the finest run; its norm is the scale. The finest run has none.
  probes,
};

struct ConvergenceRow {
  std::string formulation;
  double spacing = 0.0;  ///< [m], as it divides the body
  Index particles = 0;
  long steps = 0;                      ///< 0 if the run failed
  double dt = 0.0;                     ///< [s], the first step
  double wall_seconds = 0.0;           ///< set-up and stepping
  std::vector<double> errors, orders;  ///< one a quantity; not a number where there is none
  std::string failure;                 ///< empty when all went well
};

struct ConvergenceFit {
  std::string formulation, quantity;
  OrderFit fit;
  /// Method `probes`: what is left in the finest run, by Richardson with the fitted order.
  double finest_error = std::numeric_limits<double>::quiet_NaN();
};

struct ConvergenceTable {
  std::string scene, version;
  ConvergenceMethod method = ConvergenceMethod::exact;
  std::vector<std::string> quantities;
  std::vector<ConvergenceRow> rows;  ///< by formulation, from coarse to fine
  std::vector<ConvergenceFit> fits;  ///< by formulation and quantity
  bool interrupted = false;          ///< stopped by a signal: the rows that were done

  /// What `tlsph converge` prints.
  [[nodiscard]] std::string text() const;
  /// Writes convergence.csv and convergence.json.
  void write(const std::filesystem::path& directory) const;
};

struct ConvergenceOptions {
  /// Directory of convergence.csv and .json, rewritten after every run; method `probes` keeps its
  /// runs there too, in <formulation>/<spacing>. Empty is allowed only where there is an exact
  /// solution: nothing is written.
  std::filesystem::path out;
  int threads = 0;                                                   ///< as for a run
  std::function<void(const ConvergenceRow&)> before_run, after_run;  ///< may be empty
  std::function<void(const Progress&)> progress;                     ///< of the current run
  const std::atomic<bool>* stop_requested = nullptr;
};

/// Runs the study. InputError, before anything is written, for fewer than two spacings (three
/// without an exact solution), spacings that are not positive or the same, a formulation that does
/// not exist or stands twice, no exact solution and no probe, and all that is wrong with a scene. A
/// run that fails numerically is a row with its `failure`; the others go on.
[[nodiscard]] ConvergenceTable converge(const ConvergenceRequest& request,
                                        const ConvergenceOptions& options);

}  // namespace tlsph

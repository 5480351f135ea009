#pragma once
/// \file
/// How fast a scene's answer settles as the spacing falls. A study is made of *series* (a
/// formulation and other keys that are compared), each of *levels* from coarse to fine, each of one
/// run or of *samples*: the same body with other random particles, of which the median and the
/// worst count.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/studies/study.hpp"

namespace tlsph {

/// A key of the scene and what it is set to, one series a value.
struct Variation {
  std::string key;                  ///< as for `--set`: kernel.support, boundary[0].traction
  std::vector<std::string> values;  ///< texts as for `--set`
};

/// Reads `key=a,b,c`; commas inside brackets, braces and quotes belong to a value. InputError for
/// what is none.
[[nodiscard]] Variation parse_variation(const std::string& text);

struct ConvergenceRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;     ///< key=value, as for a run
  std::vector<double> spacings;           ///< [m], in any order
  std::vector<std::string> formulations;  ///< empty: the scene's
  std::vector<Variation> over;            ///< further keys to compare; each with each
  std::vector<std::uint64_t> seeds;       ///< samples by body.seed; empty: the scene's alone
  /// Instead of spacings: files for body.cloud, in any order, relative to the working directory.
  /// Those of equally many particles are samples of one level.
  std::vector<std::string> clouds;
  /// What is read off the probes: <probe>.<column>.<end|max|min|peak|period>. Empty: nothing with
  /// an exact solution, else peak and period of every column that has one.
  std::vector<std::string> values;
};

/// What the errors of a row are taken against.
enum class ConvergenceMethod {
  exact,  ///< the scene's exact solution, fields at the end time: `errors` of the run's summary
  /// No exact solution: for each recorded quantity, the relative L2 norm in time, over all probes
  /// and components, of the difference from the run of the next finer spacing, on the time steps of
  /// the finest run; its norm is the scale. The finest run has none.
  probes,
};

/// One run.
struct ConvergenceRow {
  std::string series;  ///< formulation and compared keys, "consistent kernel.support=2.6"
  std::string formulation;
  std::vector<std::string> over;  ///< values of the compared keys
  std::string sample;             ///< seed or file of the cloud; empty: alone on its level
  double spacing = 0.0;  ///< [m], as it divides the body; the one it is estimated at of a cloud
  Index particles = 0;
  long steps = 0;                      ///< 0 if the run failed
  double dt = 0.0;                     ///< [s], the first step
  double wall_seconds = 0.0;           ///< set-up and stepping
  std::vector<double> errors, orders;  ///< one a quantity; not a number where there is none
  std::vector<double> values;          ///< one a name of ConvergenceTable::values
  std::string failure;                 ///< empty when all went well
};

/// How samples scatter. A run that failed counts as infinitely bad, so half of them spoil the
/// median and one the worst; infinite there, not a number where there are none.
struct Spread {
  double best = not_known;
  double median = not_known;
  double worst = not_known;
};

/// The runs of a series at one spacing.
struct ConvergenceLevel {
  std::string series;
  double spacing = 0.0;
  Index particles = 0;
  int runs = 0, failed = 0;
  std::vector<Spread> errors;                       ///< one a quantity
  std::vector<double> median_orders, worst_orders;  ///< of the medians, of the worst
};

/// The order of a quantity over a series.
struct ConvergenceFit {
  std::string series, quantity;
  OrderFit fit;        ///< of the medians
  OrderFit worst_fit;  ///< of the worst
  /// Method `probes`: what is left in the finest run, by Richardson with the fitted order.
  double finest_error = not_known;
};

/// A number read off the probes, and what it tends to by Richardson: the order and the limit of the
/// three finest levels, of the medians where there are samples.
struct ConvergenceValue {
  std::string series, name;
  std::vector<double> spacings, medians, lowest, highest;  ///< by level, coarse to fine
  /// Not numbers with fewer than three levels, or where the differences change their sign or do not
  /// fall: nothing to extrapolate then.
  double order = not_known;
  double limit = not_known;
  double finest_error = not_known;  ///< |finest/limit − 1|
};

/// Best, median and worst of errors; a failure is an infinite error, what is not a number does not
/// count. The median of an even number is the mean of the middle two.
[[nodiscard]] Spread spread_of(std::vector<double> errors);

/// The levels of one series, whose rows stand from coarse to fine with samples side by side; their
/// orders, and the fit of each quantity. Errors of method `probes` are differences.
struct SeriesOrders {
  std::vector<ConvergenceLevel> levels;
  std::vector<ConvergenceFit> fits;
};
[[nodiscard]] SeriesOrders find_orders(std::span<const ConvergenceRow> rows,
                                       const std::vector<std::string>& quantities,
                                       ConvergenceMethod method);

/// The values of one series and their limits, one a name.
[[nodiscard]] std::vector<ConvergenceValue> find_limits(std::span<const ConvergenceRow> rows,
                                                        const std::vector<std::string>& names);

struct ConvergenceTable {
  std::string scene, version;
  ConvergenceMethod method = ConvergenceMethod::exact;
  std::vector<std::string> quantities;
  std::vector<std::string> over;         ///< compared keys
  std::string sample_key;                ///< body.seed, body.cloud, or empty
  std::vector<ConvergenceRow> rows;      ///< by series, from coarse to fine
  std::vector<ConvergenceLevel> levels;  ///< likewise
  std::vector<ConvergenceFit> fits;      ///< by series and quantity
  std::vector<std::string> value_names;
  std::vector<ConvergenceValue> values;  ///< by series and name
  bool interrupted = false;              ///< stopped by a signal: the rows that were done

  /// True if some level has more than one run.
  [[nodiscard]] bool sampled() const;
  /// What `tlsph converge` prints.
  [[nodiscard]] std::string text() const;
  /// Writes convergence.csv (a row a run), convergence.json and, of samples, spread.csv (a row a
  /// level and quantity).
  void write(const std::filesystem::path& directory) const;
};

/// `out` holds convergence.csv and .json, rewritten after every level; runs whose probes are read
/// are kept there too, in <series>/<spacing>[/<sample>], and in <series> the extrapolated
/// histories, probes_extrapolated.csv. Empty is allowed only where there is an exact solution and
/// no value to read: nothing is written.
struct ConvergenceOptions : StudyOptions {
  int threads = 0;                                                   ///< as for a run
  std::function<void(const ConvergenceRow&)> before_run, after_run;  ///< may be empty
  std::function<void(const Progress&)> run_progress;                 ///< of the current run
};

/// Runs the study. InputError, before anything is written, for fewer than two levels (three
/// without an exact solution), spacings that are not positive or the same, a formulation that does
/// not exist or stands twice, seeds that change nothing, no exact solution and no probe, and all
/// that is wrong with a scene. A run that fails numerically is a row with its `failure`; the others
/// go on.
[[nodiscard]] ConvergenceTable converge(const ConvergenceRequest& request,
                                        const ConvergenceOptions& options);

}  // namespace tlsph

#pragma once
/// \file
/// Speed against accuracy: what a scene costs in many configurations and how far each is from the
/// answer, within a budget of time. A configuration is a *family* (formulation, kernel, support,
/// order, stabiliser) at a spacing, in *variants* of time step and law.

#include <optional>
#include <string>
#include <vector>

#include "tlsph/simulation/simulation.hpp"
#include "tlsph/studies/study.hpp"

namespace tlsph {

/// A number to read off a probe, and what it must be. Without an answer it is extrapolated from
/// three spacings of the scene as it stands.
struct ChartValue {
  std::string name;  ///< <probe>.<column>.<end|max|min|peak|period>
  std::optional<double> answer;
};

/// Reads `name` or `name=answer`. InputError for what is neither.
[[nodiscard]] ChartValue parse_chart_value(const std::string& text);

struct ChartRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;     ///< key=value, as for a run
  double budget = 120.0;                  ///< wall time of the study [s]
  std::vector<double> spacings;           ///< [m]; empty: 4, 2, 1, 1/2 … of the scene's
  std::vector<std::string> formulations;  ///< empty: all
  std::vector<ChartValue> values;         ///< beside, or instead of, the exact solution
  std::vector<std::string> peers;         ///< scripts of validation/peers
};

/// A configuration but for its spacing.
struct ChartModel {
  std::string family;  ///< "variational 2.5 order 2 pair viscosity"; of a peer its note
  std::vector<std::string> overrides;           ///< key=value, for `tlsph run`
  std::string formulation, kernel, stabiliser;  ///< empty for a peer
  std::optional<double> support;                ///< [spacings]; empty: the nodes of a cell
  int order = 0;
  std::optional<double> step_share;  ///< of the critical step; empty: the scene or the peer gives
                                     ///< the step
};

/// A configuration and its runs, of this program or of a peer.
struct ChartPoint : ChartModel {
  std::string peer;      ///< empty: this program; "fe_q4 linear step 0.99": script and variant
  std::string law;       ///< of the materials, joined by "+"; empty for a peer that does not say
  double spacing = 0.0;  ///< [m]
  Index particles = 0;
  long steps = 0;
  double setup_seconds = 0.0;   ///< the first run's
  std::vector<double> seconds;  ///< stepping, one a repetition
  std::vector<double> errors;   ///< relative, one a quantity; not a number where there is none
  /// What it is judged by: of single numbers, which may hit their answer by chance, not better than
  /// the next finer spacing of the family; not a number where there is no other spacing. Of a peer,
  /// which nobody picked from many, the error itself.
  std::vector<double> judged;
  std::vector<bool> front;  ///< one a quantity: nothing is both faster and nearer
  std::string failure;      ///< empty when all went well

  /// Median of `seconds`.
  [[nodiscard]] double time() const;
};

struct ChartTable {
  std::string scene, version;
  double budget = 0.0, spent = 0.0;  ///< [s]
  int threads = 1;
  std::vector<std::string> quantities;
  std::vector<double> answers;  ///< one a quantity; not a number for fields
  std::vector<ChartPoint> points;
  int families = 0;   ///< considered
  int variants = 0;   ///< of law and time step that the best of these were given
  int refused = 0;    ///< of the families, what the scene does not allow
  int dominated = 0;  ///< of both, given up because others are faster and nearer at once
  std::vector<std::string> notes;  ///< peers that could not run, and why
  bool interrupted = false;

  /// Which quantities are single numbers, one a quantity; the others are fields.
  [[nodiscard]] std::vector<bool> single_numbers() const;
  /// Judges the points and marks the front of every quantity among those that did not fail.
  void mark_fronts();
  /// What `tlsph chart` prints: the front of each quantity, and the peers against it.
  [[nodiscard]] std::string text() const;
  /// Writes chart.csv and chart.json.
  void write(const std::filesystem::path& directory) const;
};

/// Which points are on the front: no other is as fast and as accurate, and better in one of both.
/// Values that are not finite are on none.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<double>& times,
                                             const std::vector<double>& errors);

/// `out` holds chart.csv, chart.json and what the runs leave.
struct ChartOptions : StudyOptions {
  int threads = 1;  ///< of every run; peers take one
};

/// Runs the study. First every family at the coarsest spacing, those nearest to the defaults first,
/// for a part of the budget; then, again and again, the refinement that promises to gain most
/// beyond the front for its predicted cost, families that can no longer reach it left out; those on
/// the front, or near it, are also tried with other shares of the critical step and with a linear
/// law, whose error is measured like any other; at last the front's times are repeated. A peer that
/// can choose both has the same freedom. InputError, before anything is written, for a scene
/// without exact solution and without value, values that cannot be read, a peer that is none, and
/// all that is wrong with the scene as it stands.
[[nodiscard]] ChartTable chart(const ChartRequest& request, const ChartOptions& options);

}  // namespace tlsph

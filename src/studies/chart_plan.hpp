#pragma once
/// \file
/// What a chart measures, and at which spacings, judged before anything runs; and the study while
/// it runs.

#include <functional>
#include <string>
#include <vector>

#include "chart_families.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/studies/chart.hpp"

namespace tlsph {

struct ChartPlan {
  Scene scene;                          ///< as it stands
  std::vector<double> ladder;           ///< spacings [m], coarse to fine
  std::vector<std::string> quantities;  ///< fields of the exact solution, then values
  std::vector<std::string> values;      ///< names of these
  std::vector<double> answers;          ///< one a quantity; not a number: a field, or not known yet
};

/// Reads and builds the scene as it stands at its coarsest spacing. Throws InputError.
[[nodiscard]] ChartPlan plan_chart(const ChartRequest& request);

/// One a value of the request: its answer, or the limit by Richardson from the scene as it stands
/// at twice, once and half its spacing h [m]; the finest where the last two agree so well that
/// their difference is noise. Runs are kept in `out`/answer. InputError for a value that does not
/// settle.
[[nodiscard]] std::vector<double> find_answers(const ChartRequest& request, double h,
                                               const StudyOptions& options, int threads,
                                               const std::function<void()>& progress);

struct ChartStudy {
  const ChartRequest& request;
  const ChartPlan& plan;
  const ChartOptions& options;
  ChartVariation variation = chart_variation(plan.scene);
  ChartTable table = {};
  Stopwatch watch = {};

  [[nodiscard]] double spent() const { return watch.seconds(); }  ///< [s]
  void show(const std::string& what) const;
  /// Adds a point to the table; writes the files every 20 points, in case the study is killed.
  void add(ChartPoint point);
  /// Judges the points and writes the files.
  void write();
};

}  // namespace tlsph

#include "chart_answers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

/// Share of a value that its change from one spacing to the next may be to count as noise.
constexpr double settled = 1e-5;

double limit_of(const ConvergenceValue& value, const std::vector<double>& spacings) {
  if (std::isfinite(value.limit) && value.limit != 0.0) return value.limit;
  if (const std::size_t n = value.medians.size(); n >= 3) {
    const double finest = value.medians[n - 1];
    if (finest != 0.0 && std::abs(finest - value.medians[n - 2]) <= settled * std::abs(finest))
      return finest;
  }
  throw InputError({"--value " + value.name, 0, 0, ""},
                   fmt::format("does not settle at the spacings {:.4g}, {:.4g} and {:.4g}: give "
                               "its answer, {}=…",
                               spacings[0], spacings[1], spacings[2], value.name));
}

}  // namespace

std::vector<double> find_answers(const ChartRequest& request, double h, const StudyOptions& options,
                                 int threads, const std::function<void()>& progress) {
  std::vector<double> answers;
  ConvergenceRequest study;
  for (const ChartValue& value : request.values) {
    answers.push_back(value.answer.value_or(not_known));
    if (!value.answer) study.values.push_back(value.name);
  }
  if (study.values.empty()) return answers;
  study.scene = request.scene;
  study.overrides = request.overrides;
  study.spacings = {2.0 * h, h, 0.5 * h};
  ConvergenceOptions study_options;
  study_options.out = options.out / "answer";
  study_options.threads = threads;
  study_options.stop_requested = options.stop_requested;
  study_options.progress = [&](const Progress&) { progress(); };
  const ConvergenceTable table = converge(study, study_options);
  if (table.interrupted) return answers;
  for (const ConvergenceValue& value : table.values)
    for (std::size_t k = 0; k < answers.size(); ++k)
      if (request.values[k].name == value.name) answers[k] = limit_of(value, study.spacings);
  return answers;
}

}  // namespace tlsph

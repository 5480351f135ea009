#pragma once
/// \file
/// What a convergence study is going to run, judged before anything runs.

#include <string>
#include <vector>

#include "tlsph/studies/converge.hpp"

namespace tlsph {

/// One run to come.
struct PlannedRun {
  Scene scene;
  std::filesystem::path folder;  ///< <series>/<spacing as asked for>[/<sample>]
  ConvergenceRow row;            ///< as far as it is known before the run
};

/// Levels from coarse to fine, each of samples.
using PlannedSeries = std::vector<std::vector<PlannedRun>>;

struct ConvergencePlan {
  ConvergenceMethod method = ConvergenceMethod::exact;
  std::vector<PlannedSeries> series;
};

/// From coarse to fine. InputError, naming the option, for what is no spacing or stands twice.
[[nodiscard]] std::vector<double> sorted_spacings(std::vector<double> spacings);
/// InputError, naming the option, for a name that is no formulation.
void check_formulations(const std::vector<std::string>& names);

/// Builds all that a run of the scene is made of and drops it. Throws InputError.
void check_buildable(const Scene& scene);

/// Reads every scene of the study, divides its body and builds the coarsest of each series, so that
/// what cannot run is refused here. Throws InputError.
[[nodiscard]] ConvergencePlan plan_convergence(const ConvergenceRequest& request);

}  // namespace tlsph

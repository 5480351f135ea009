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
  std::string sample;            ///< seed or file of the cloud; empty: alone on its level
  std::filesystem::path folder;  ///< <series>/<spacing as asked for>[/<sample>]
  double spacing = 0.0;  ///< [m], as it divides the body; the one it is estimated at of a cloud
  Index particles = 0;
};

struct PlannedSeries {
  std::string label, formulation;
  std::vector<std::string> over;                ///< values of the compared keys
  std::vector<std::vector<PlannedRun>> levels;  ///< from coarse to fine, each of samples
};

struct ConvergencePlan {
  ConvergenceMethod method = ConvergenceMethod::exact;
  std::vector<PlannedSeries> series;
};

/// From coarse to fine. InputError, naming the option, for what is no spacing or stands twice.
[[nodiscard]] std::vector<double> sorted_spacings(std::vector<double> spacings);
/// InputError, naming the option, for a name that is no formulation.
void check_formulations(const std::vector<std::string>& names);

/// Reads every scene of the study, divides its body and builds the coarsest of each series, so that
/// what cannot run is refused here. Throws InputError.
[[nodiscard]] ConvergencePlan plan_convergence(const ConvergenceRequest& request);

}  // namespace tlsph

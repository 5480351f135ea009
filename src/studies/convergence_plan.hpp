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
  std::filesystem::path folder;  ///< <formulation>/<spacing>, as asked for
  double spacing = 0.0;          ///< [m], as it divides the body
  Index particles = 0;
};

struct ConvergencePlan {
  ConvergenceMethod method = ConvergenceMethod::exact;
  std::vector<std::vector<PlannedRun>> runs;  ///< by formulation, each from coarse to fine
};

/// Reads every scene of the study, divides its body and builds the coarsest of each formulation, so
/// that what cannot run is refused here. Throws InputError.
[[nodiscard]] ConvergencePlan plan_convergence(const ConvergenceRequest& request);

}  // namespace tlsph

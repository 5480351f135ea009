#pragma once
/// \file
/// What a chart measures, and at which spacings, judged before anything runs.

#include <vector>

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

}  // namespace tlsph

#pragma once
/// \file
/// What a fit measures, and the scene its models start from.

#include "chart_families.hpp"
#include "tlsph/studies/fit.hpp"

namespace tlsph {

struct FitPlan {
  Scene scene;                          ///< reduced, with nothing but the output that is read
  double spacing = 0.0;                 ///< of the scene as it stands [m]
  std::vector<std::string> reductions;  ///< in words
  std::string quantity;
  std::vector<ChartFamily> families;
  std::vector<std::string> linear;  ///< overrides for a linear law; empty where it is linear, or
                                    ///< where the exact solution follows the law
};

/// Throws InputError.
[[nodiscard]] FitPlan plan_fit(const FitRequest& request);

/// The coarsest division of the body with a spacing of at most `spacing` [m]; 0 if there is none.
[[nodiscard]] double next_division(const Scene& scene, double spacing);

}  // namespace tlsph

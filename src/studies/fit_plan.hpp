#pragma once
/// \file
/// What a fit measures, the scene its models start from, one run of a model, and what the runs of a
/// family come to.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chart_families.hpp"
#include "tlsph/studies/fit.hpp"

namespace tlsph {

struct FitPlan {
  Scene scene;                          ///< reduced, with nothing but the output that is read
  ChartRequest study;                   ///< the scene as it stands, its value and its spacing
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

/// Runs the scene, several times where that is short: the least time counts. The error is that of
/// the request's field, or of its value against `answer`, then with its sign; not a number where
/// the value has none, e.g. no period. Empty if it was interrupted. InputError, NumericalError.
[[nodiscard]] std::optional<Pilot> run_pilot(const FitRequest& request, double answer,
                                             const Scene& scene, const FitOptions& options,
                                             const std::function<void()>& progress);

/// Fills what the pilots of a family predict for the coarsest division of the body of `scene` that
/// reaches the error; `reaches` is false if there is no such division.
void conclude(FitFamily& family, double error, const Scene& scene);

}  // namespace tlsph

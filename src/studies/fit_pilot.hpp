#pragma once
/// \file
/// One run of a fit: what it takes and how far it is from the answer; and what the runs of a family
/// come to.

#include <functional>
#include <optional>

#include "tlsph/studies/fit.hpp"

namespace tlsph {

/// Runs the scene, several times where that is short: the least time counts. The error is that of
/// the request's field, or of its value against `answer`, then with its sign; not a number where
/// the value has none, e.g. no period. Empty if it was interrupted. InputError, NumericalError.
[[nodiscard]] std::optional<Pilot> run_pilot(const FitRequest& request, double answer,
                                             const Scene& scene, const FitOptions& options,
                                             const std::function<void()>& progress);

/// Fills what the pilots of a family predict for the coarsest division of the body of `scene` that
/// reaches the error; `reaches` is false if there is no such division.
void conclude(FitFamily& family, double error, const Scene& scene, int dimension);

}  // namespace tlsph

#pragma once
/// \file
/// What the values of a chart tend to, where nobody said what they must be.

#include <functional>
#include <vector>

#include "tlsph/studies/chart.hpp"

namespace tlsph {

/// One a value of the request: its answer, or the limit by Richardson from the scene as it stands
/// at twice, once and half its spacing h [m]; the finest where the last two agree so well that
/// their difference is noise. Runs are kept in `out`/answer. InputError for a value that does not
/// settle.
[[nodiscard]] std::vector<double> find_answers(const ChartRequest& request, double h,
                                               const StudyOptions& options, int threads,
                                               const std::function<void()>& progress);

}  // namespace tlsph

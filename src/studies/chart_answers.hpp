#pragma once
/// \file
/// What the values of a chart tend to, where nobody said what they must be.

#include <atomic>
#include <filesystem>
#include <functional>
#include <vector>

#include "tlsph/studies/chart.hpp"

namespace tlsph {

/// One a value of the request: its answer, or the limit by Richardson from the scene as it stands
/// at twice, once and half its spacing h [m]; the finest where the last two agree so well that
/// their difference is noise. Runs are kept in `folder`. InputError for a value that does not
/// settle.
[[nodiscard]] std::vector<double> find_answers(const ChartRequest& request, double h, int threads,
                                               const std::filesystem::path& folder,
                                               const std::function<void()>& progress,
                                               const std::atomic<bool>* stop_requested);

}  // namespace tlsph

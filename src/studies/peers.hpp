#pragma once
/// \file
/// Other programs on the same scene: scripts validation/peers/<name>.py, called with the scene's
/// name, a spacing, an end time and, for those that can choose, a share of the critical step and a
/// law, answering with one line of JSON (validation/peers/README.md).

#include <string>
#include <vector>

#include "chart_plan.hpp"

namespace tlsph {

/// InputError, naming `--peer` and those there are, for a name that is none; and for overrides that
/// make the scene another than the peers know.
void check_peers(const std::vector<std::string>& names, const std::vector<std::string>& overrides);

/// Runs the peers of the request until so many seconds of the study are spent, each from spacing to
/// spacing within its part of the time, in the variants of time step and law that it can be given.
void run_peers(ChartStudy& study, double until);

}  // namespace tlsph

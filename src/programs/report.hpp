#pragma once
/// \file
/// The lines a run or a study ends with on the screen.

#include <filesystem>
#include <string>

#include "tlsph/simulation/summary.hpp"
#include "tlsph/studies/converge.hpp"
#include "tlsph/studies/figure.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

[[nodiscard]] std::string run_report(const Summary& summary, const std::filesystem::path& out);

/// One run of a study, as it ends.
[[nodiscard]] std::string run_line(const ConvergenceRow& row);

/// Where the files of a study are, and how to draw the figure if that did not work.
[[nodiscard]] std::string results_report(const std::filesystem::path& out, const Figure& figure);

/// One case of `validate`, as it ends.
[[nodiscard]] std::string case_line(const CaseResult& result);

}  // namespace tlsph

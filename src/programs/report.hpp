#pragma once
/// \file
/// The lines a run ends with on the screen.

#include <filesystem>
#include <string>

#include "tlsph/simulation/summary.hpp"

namespace tlsph {

[[nodiscard]] std::string run_report(const Summary& summary, const std::filesystem::path& out);

}  // namespace tlsph

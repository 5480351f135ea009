#pragma once
/// \file
/// The books of a run, from its run.h5.

#include <filesystem>
#include <string>
#include <vector>

namespace tlsph {

struct RunSeries {
  std::vector<double> time;    ///< [s]
  std::vector<double> values;  ///< of one quantity without components
};

/// /series/`quantity` of the run in that directory.
[[nodiscard]] RunSeries read_series(const std::filesystem::path& directory,
                                    const std::string& quantity);

}  // namespace tlsph

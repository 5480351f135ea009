#pragma once
/// \file
/// Figures of a study, drawn by validation/plot.py. A figure is a convenience: nothing fails for
/// the want of one.

#include <filesystem>
#include <string>

namespace tlsph {

struct Figure {
  bool drawn = false;
  std::filesystem::path file;  ///< where it is, or would be
  std::string command;         ///< what draws it
};

/// The folder of the validation cases and of plot.py: $TLSPH_VALIDATION, else that of the
/// installation this program is from (share/tlsph/validation beside its bin), else that of the
/// source tree. Empty if there is none.
[[nodiscard]] std::filesystem::path validation_folder();

/// `plot.py KIND DATA --out FILE`; FILE is DATA with the suffix .png if it is empty. The script is
/// $TLSPH_PLOT, else that of the validation folder; Python is /usr/bin/python3, else the first on
/// the path.
[[nodiscard]] Figure draw_figure(const std::string& kind, const std::filesystem::path& data,
                                 const std::filesystem::path& file = {});

}  // namespace tlsph

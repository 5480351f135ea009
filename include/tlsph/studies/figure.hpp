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

/// `plot.py KIND DATA`: writes DATA with the suffix .png. The script is $TLSPH_PLOT, else that of
/// the installation this program is from (share/tlsph/plot.py beside its bin), else that of the
/// source tree; Python is /usr/bin/python3, else the first on the path.
[[nodiscard]] Figure draw_figure(const std::string& kind, const std::filesystem::path& data);

}  // namespace tlsph

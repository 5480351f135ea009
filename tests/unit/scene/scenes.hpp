#pragma once
/// \file
/// Small sound scenes that the tests change.

#include <string>
#include <vector>

#include "tlsph/scene/reader.hpp"

namespace tlsph {

/// Only what a scene must have, in 1D.
inline const std::string smallest_bar = R"(dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[time]
end = 1e-3
)";

/// Only what a scene must have, in 2D.
inline const std::string smallest_sheet = R"([body]
shape = { box = [[0.0, 0.0], [2.0, 1.0]] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[time]
end = 1e-3
)";

inline Scene bar_with(const std::vector<std::string>& overrides) {
  return read_scene_text(smallest_bar, "bar.toml", overrides);
}

inline Scene sheet_with(const std::vector<std::string>& overrides) {
  return read_scene_text(smallest_sheet, "sheet.toml", overrides);
}

}  // namespace tlsph

#pragma once
/// \file
/// A linear law in the place of the scene's.

#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// key=value of a run that makes every material of the scene linear elastic; empty where all are,
/// and where the exact solution is one of large strain.
[[nodiscard]] std::vector<std::string> linear_law(const Scene& scene);

}  // namespace tlsph

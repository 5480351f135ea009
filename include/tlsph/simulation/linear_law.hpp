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

/// Whether the scene strains its body so little, by an estimate on the safe side, that laws differ
/// by less than a run resolves.
[[nodiscard]] bool linear_law_serves(const Scene& scene);

}  // namespace tlsph

#pragma once
/// \file
/// Where the keys of a scene stand, for errors that only show when its body is built.

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Where `key` stands in the scene's file; of one that is not there, where the table around it
/// does.
[[nodiscard]] Place place_of(const Scene& scene, const std::string& key);

}  // namespace tlsph

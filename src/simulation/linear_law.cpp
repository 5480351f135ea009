#include "tlsph/simulation/linear_law.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "savings.hpp"

namespace tlsph {

std::vector<std::string> linear_law(const Scene& scene) {
  const bool linear = std::ranges::all_of(scene.materials, [](const MaterialScene& material) {
    return material.law == LawName::linear_elastic;
  });
  if (linear || scene.exact == ExactKind::uniform_stretch) return {};
  std::vector<std::string> overrides = {"material.law=linear-elastic"};
  for (std::size_t k = 1; k < scene.materials.size(); ++k)
    overrides.push_back(fmt::format("material.region[{}].law=linear-elastic", k - 1));
  return overrides;
}

bool linear_law_serves(const Scene& scene) {
  return savings::strain_estimate(scene) < savings::small_strain;
}

}  // namespace tlsph

#include <fmt/format.h>

#include <vector>

#include "savings.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/reduction.hpp"

namespace tlsph::savings {
namespace {

/// Particles of the smaller scene, of a formulation all scenes have; 0 if it is none after all.
Index particles_of(const Scene& scene, const Reduction& reduction) {
  std::vector<std::string> removed = reduction.removed;
  for (const char* key : {"formulation", "kernel", "stabiliser", "consistency", "body.placement"})
    removed.emplace_back(key);
  try {
    const Scene smaller = read_scene_text(
        edit_scene_text(scene.text, scene.file, removed, reduction.overrides), scene.file);
    return in_dimension(smaller.dimension,
                        [&]<int D>() { return build_particles<D>(smaller).size(); });
  } catch (const InputError&) {
    return 0;
  }
}

std::string line(const Scene& scene, const Reduction& reduction, Index particles) {
  const Index fewer = particles_of(scene, reduction);
  if (fewer == 0 || fewer >= particles) return "";
  return fmt::format("  {}; {} particles in place of {}\n", reduction.what, fewer, particles);
}

}  // namespace

std::string of_reduction(const Scene& scene, Index particles) {
  if (const auto bar = to_one_dimension(scene)) return line(scene, *bar, particles);
  std::string text;
  for (const int axis : {0, 1})
    if (const auto half = to_half(scene, axis)) text += line(scene, *half, particles);
  return text;
}

}  // namespace tlsph::savings

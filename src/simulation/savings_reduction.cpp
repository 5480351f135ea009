#include <fmt/format.h>

#include "savings.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/simulation/reduction.hpp"

namespace tlsph::savings {
namespace {

/// Particles of the smaller scene, of a formulation all scenes have; 0 if it is none after all.
Index particles_of(const Reduction& reduction) {
  const Scene standard;
  Scene smaller = reduction.scene;
  smaller.formulation = standard.formulation;
  smaller.kernel = {};
  smaller.stabiliser = {};
  smaller.consistency = standard.consistency;
  smaller.body.placement = standard.body.placement;
  try {
    smaller = completed(smaller);
    return in_dimension(smaller.dimension,
                        [&]<int D>() { return build_particles<D>(smaller).size(); });
  } catch (const InputError&) {
    return 0;
  }
}

std::string line(const Reduction& reduction, Index particles) {
  const Index fewer = particles_of(reduction);
  if (fewer == 0 || fewer >= particles) return "";
  return fmt::format("  {}; {} particles in place of {}\n", reduction.what, fewer, particles);
}

}  // namespace

std::string of_reduction(const Scene& scene, Index particles) {
  if (const auto bar = to_one_dimension(scene)) return line(*bar, particles);
  std::string text;
  for (const int axis : {0, 1})
    if (const auto half = to_half(scene, axis)) text += line(*half, particles);
  return text;
}

}  // namespace tlsph::savings

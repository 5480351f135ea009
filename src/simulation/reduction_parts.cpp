#include "reduction_parts.hpp"

namespace tlsph {

bool is_plain(const Scene& scene) {
  return scene.dimension == 2 && !scene.body.is_cloud() && scene.body.jitter == 0.0 &&
         scene.body.tags.empty() && scene.initial_regions.empty();
}

const Box<2>* plain_box(const Scene& scene) {
  const auto* shape = std::get_if<Shape<2>>(&scene.body.shape);
  return shape != nullptr && is_plain(scene) ? std::get_if<Box<2>>(&shape->form) : nullptr;
}

}  // namespace tlsph

#pragma once
/// \file
/// Smaller scenes with the same answer: one dimension where nothing depends on the other, half a
/// body where the other half is its mirror image. Judged from what the scene says, before anything
/// is built. A mirror image of the body may still buckle out of its plane: what the scene does not
/// excite, the smaller one cannot show.

#include <optional>
#include <string>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

struct Reduction {
  /// "1D: nothing depends on y", "half of it: x = 0.05 m is a plane of symmetry".
  std::string what;
  Scene scene;  ///< the smaller one, to be completed (scene/edit.hpp)
};

/// A box under plane strain whose long sides slide along rigid walls and which is loaded, held,
/// made and started alike over its height is a bar in 1D strain. Empty for all other scenes.
[[nodiscard]] std::optional<Reduction> to_one_dimension(const Scene& scene);

/// The half of a 2D body on one side of the plane through its middle that is normal to `axis`,
/// rollers on the cut: shape, conditions, loads, materials and start must be mirror images of each
/// other, and all probes on one side, which is the half kept. Boxes, and boxes with holes that are
/// boxes or discs. Empty for all other scenes.
[[nodiscard]] std::optional<Reduction> to_half(const Scene& scene, int axis);

}  // namespace tlsph

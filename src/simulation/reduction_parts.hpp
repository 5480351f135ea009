#pragma once
/// \file
/// Questions both reductions of a scene ask.

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// A body of 2D on a lattice that is what its shape says: no points of a file, no rows shifted, no
/// random shifts, no patches by name, no parts that start differently.
[[nodiscard]] bool is_plain(const Scene& scene);

/// The box of such a body; nullptr for all others.
[[nodiscard]] const Box<2>* plain_box(const Scene& scene);

}  // namespace tlsph

#pragma once
/// \file
/// [body]: shape, spacing, placement, tags.

#include <vector>

#include "tlsph/scene/scene.hpp"
#include "view.hpp"

namespace tlsph {

[[nodiscard]] BodyScene read_body(const TableView& view, int dimension, Formulation formulation);

/// Two opposite corners of a box, `[lower, upper]`; in 1D also `[from, to]`.
struct CornerPair {
  std::vector<double> lower, upper;
};
[[nodiscard]] CornerPair read_box(const Node& node, int dimension);

}  // namespace tlsph

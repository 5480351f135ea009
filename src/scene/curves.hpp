#pragma once
/// \file
/// Curves in a scene: read and printed.

#include <optional>
#include <vector>

#include "document.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// The motion of one component: a number, or a curve with a number as amplitude.
[[nodiscard]] Curve read_motion_curve(const Node& node);

/// A load: a number or curve is `normal`, a list or a curve with a list as amplitude has a number
/// per dimension.
void read_load(const Node& node, int dimension, std::optional<Curve>& normal,
               std::vector<ComponentCurve>& components);

/// A number where the curve is constant, else its table.
[[nodiscard]] Node print_curve(const Curve& curve);

/// A load by components, which differ in nothing but their amplitude. The values of a table curve
/// are those of its first component: the others come back to rounding.
[[nodiscard]] Node print_vector_load(const std::vector<ComponentCurve>& load, int dimension);

}  // namespace tlsph

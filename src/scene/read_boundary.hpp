#pragma once
/// \file
/// [[boundary]] and the load curves in it.

#include <string>

#include "tlsph/scene/scene.hpp"
#include "view.hpp"

namespace tlsph {

[[nodiscard]] BoundaryScene read_boundary(const TableView& view, int dimension);

}  // namespace tlsph

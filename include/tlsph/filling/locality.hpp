#pragma once
/// \file
/// The order of scattered nodes: neighbours in space should be neighbours in memory.

#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// An order in which nodes `X` (N×d [m]) follow one another along strips as wide as their mean
/// distance, like the rows of a lattice (last coordinate fastest), so that a step passes over the
/// body through a window of a few rows. Result k is the node to come k-th. Empty if the order there
/// is does as well: three nodes in four are within three mean distances of the one before.
template <int D>
[[nodiscard]] std::vector<int> local_order(const VectorField<D>& X);

}  // namespace tlsph

#pragma once
/// \file
/// The updated-Lagrangian counter-example in the material of the atlas: kernel sums that follow the
/// particles, a few stresses.

#include "specimen.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// In as many dimensions as the body has, one particle of a lattice under uniform stress pushed.
[[nodiscard]] std::vector<ContrastRow> contrast_rows(const Subject& subject);

}  // namespace tlsph

#pragma once
/// \file
/// Material points: where deformation and stress live.

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// One stress point per cell at the mean of its corners, with the volume of the cell: Σ V = |body|.
/// InputError if the particles have no cells (cell-centred placement).
template <int D>
[[nodiscard]] MaterialPoints<D> cell_points(const Particles<D>& particles);

/// The nodes themselves, for collocated formulations.
template <int D>
[[nodiscard]] MaterialPoints<D> node_points(const Particles<D>& particles);

}  // namespace tlsph

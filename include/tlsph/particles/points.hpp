#pragma once
/// \file
/// Material points: where deformation and stress live.

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// One stress point per cell at the mean of its corners, with the volume of the cell: Σ V = |body|.
/// In a 2D cloud one per edge of its triangles, with a third of the triangles on both sides, at
/// their centre of area; Σ V X = ∫X dV too. InputError if the particles have neither (cell-centred
/// placement).
template <int D>
[[nodiscard]] MaterialPoints<D> cell_points(const Particles<D>& particles);

/// The nodes themselves, for collocated formulations.
template <int D>
[[nodiscard]] MaterialPoints<D> node_points(const Particles<D>& particles);

}  // namespace tlsph

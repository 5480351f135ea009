#pragma once
/// \file
/// Measures of cells, deformed ones too (intervals in 1D, quadrilaterals with straight edges in
/// 2D), and the material points in them: where deformation and stress live.

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Length or area [m^d] of a cell, positive for corners in their right order.
template <int D>
[[nodiscard]] double cell_volume(const VectorField<D>& X, const Cell<D>& cell);

/// Smallest Jacobian [m^d] over the corners of a cell (2D: cross product of the two edges that meet
/// there; 1D: length). The cell is strictly convex exactly if it is positive.
template <int D>
[[nodiscard]] double least_jacobian(const VectorField<D>& X, const Cell<D>& cell);

/// Mean of the corners.
template <int D>
[[nodiscard]] Vector<D> cell_centre(const VectorField<D>& X, const Cell<D>& cell);

/// N node volumes [m^d]. A quadrilateral is cut from the mean of its corners to the middles of its
/// edges; each of its four parts goes to the corner it holds. Σ V = Σ cell volumes.
template <int D>
[[nodiscard]] ScalarField node_volumes(const VectorField<D>& X, const std::vector<Cell<D>>& cells);

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

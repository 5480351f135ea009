#pragma once
/// \file
/// Measures of deformed cells: intervals in 1D, quadrilaterals with straight edges in 2D.

#include <vector>

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

}  // namespace tlsph

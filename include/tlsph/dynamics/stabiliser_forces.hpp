#pragma once
/// \file
/// What a stabiliser that acts as stiffness does, S u and ½ uᵀ S u, whether the discretisation
/// holds S as a matrix or by its hourglass modes, S = Aᵀ κ A. All sums are over differences of u:
/// the rows of S sum to zero, and a body that has travelled far keeps its digits.

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

template <int D>
[[nodiscard]] bool has_stabiliser(const Discretisation<D>& body) {
  return !body.hourglass.empty() || body.stiffness.nonZeros() > 0;
}

/// f −= S u (N×d both) [N per thickness]. Takes nothing from the heap.
template <int D>
void subtract_stabiliser(const Discretisation<D>& discretisation, const VectorField<D>& u,
                         VectorField<D>& f);

/// (S u)_q for one node, as `subtract_stabiliser` sums it.
template <int D>
[[nodiscard]] Vector<D> stabiliser_row(const Discretisation<D>& discretisation, Index q,
                                       const VectorField<D>& u);

/// ½ uᵀ S u [J per thickness].
template <int D>
[[nodiscard]] double stabiliser_energy(const Discretisation<D>& discretisation,
                                       const VectorField<D>& u);

/// S, multiplied out; 0×0 without a stabiliser.
template <int D>
[[nodiscard]] SparseMatrix stabiliser_matrix(const Discretisation<D>& discretisation);

}  // namespace tlsph

#pragma once
/// \file
/// The gradient that the pair stabiliser measures its pair errors with: as narrow as the nodes
/// allow, so that S has few entries, and determined on any set of nodes.

#include "tlsph/operators/vector_operator.hpp"

namespace tlsph {

/// A gradient (N×N) at the nodes X (N×d) [m] with volumes V (N) [m^d], exact for polynomials of
/// `degree` 1 or 2. Every node starts with the nodes within 1.515 spacings, a kernel gradient with
/// the correction of Bonet & Lok; where that is not exact for the degree, or Σ_q |G_pq| of it is
/// larger than a one-sided difference in the corner of a lattice needs, least-squares fits over
/// wider neighbourhoods follow (degree 1: corrected kernel gradients) until it is. On a lattice of
/// squares the kernel gradient stands wherever the degree is 1, or the neighbourhood is symmetric.
/// Nodes that determine no fit of degree two within four spacings have one of degree one.
/// InputError if all nodes stand on a line of the plane.
template <int D>
[[nodiscard]] VectorOperator<D> pair_gradient(const VectorField<D>& X, const ScalarField& V,
                                              double spacing, int degree);

}  // namespace tlsph

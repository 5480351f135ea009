#pragma once
/// \file
/// Stabilisers: constant, symmetric, positive semi-definite matrices that vanish on linear fields
/// and see what G does not, the checkerboard (½ uᵀ S u is an energy and rigid motions are linear
/// fields, so both momenta are kept).

#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Pairs nearer than this many spacings take part in the pair stabiliser.
inline constexpr double pair_cutoff = 1.6;

/// S = Σ over pairs p<q nearer than 1.6 Δ of √(V_p V_q)/r² a aᵀ, with aᵀu the pair error
/// u_q − u_p − ½(G_p u + G_q u)·(X_q − X_p), each pair times the mean of `modulus` (N, [Pa] for a
/// stiffness) at its ends. `gradient` is a collocated linear-exact gradient (N×N).
template <int D>
[[nodiscard]] SparseMatrix pair_stabiliser(const VectorOperator<D>& gradient,
                                           const VectorField<D>& X, const ScalarField& V,
                                           double spacing, const ScalarField& modulus);

/// The rows γ of the cell stabiliser (cells × nodes): γ_q = ¼(h_q − Σ_a G^a_sq Σ_r h_r X^a_r),
/// h = (1, −1, 1, −1) around the cell; γ·u is the hourglass amplitude of a quadrilateral.
[[nodiscard]] SparseMatrix hourglass_rows(const Particles<2>& particles,
                                          const VectorOperator<2>& gradient);

/// Aᵀ diag(κ) A for rows A; κ [Pa] a value per cell.
[[nodiscard]] SparseMatrix normal_matrix(const SparseMatrix& rows, const ScalarField& kappa);

}  // namespace tlsph

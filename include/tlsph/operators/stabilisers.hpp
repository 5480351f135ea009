#pragma once
/// \file
/// Stabilisers: constant, symmetric, positive semi-definite matrices that vanish on linear fields
/// and see what G does not, the checkerboard.
///
/// As stiffness ½ uᵀ S u is an energy and S knows neither translations nor X: Σ S u = 0, and x × S
/// u with x = X + u sums to the antisymmetric part of uᵀ S u, which is zero: both momenta are kept.
/// As viscosity, C = S with other units, −C v takes the power vᵀ C v ≥ 0 from the body and keeps
/// its linear momentum; of the angular one it leaves the antisymmetric part of uᵀ C v, zero for
/// motions that are linear in X and small beside them.
///
/// `coefficient = "auto"`: cells (4/3) E/(1−ν²) [E in plane stress], with which one-point
/// rectangles bend exactly; pairs 0.1 μ as stiffness, 0.3 μ beside `consistent` gradients of order
/// two; as viscosity 0.4 ρ c_s Δ, 0.2 ρ c_s Δ beside gradients of order two, about where the
/// critical step begins to feel it.

#include <vector>

#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Pairs nearer than this many spacings take part in the pair stabiliser.
inline constexpr double pair_cutoff = 1.6;

/// The gradient that the pair stabiliser measures its pair errors with: as narrow as the nodes
/// allow, so that S has few entries, and determined on any set of nodes. It is N×N, at the nodes X
/// (N×d) [m] with volumes V (N) [m^d], exact for polynomials of `degree` 1 or 2.
///
/// Every node starts with the nodes within 1.515 spacings, a kernel gradient with the correction of
/// Bonet & Lok; where that is not exact for the degree, or Σ_q |G_pq| of it is larger than a
/// one-sided difference in the corner of a lattice needs, least-squares fits over wider
/// neighbourhoods follow (degree 1: corrected kernel gradients) until it is. On a lattice of
/// squares the kernel gradient stands wherever the degree is 1, or the neighbourhood is symmetric.
/// Nodes that determine no fit of degree two within four spacings have one of degree one.
/// InputError if all nodes stand on a line of the plane.
template <int D>
[[nodiscard]] VectorOperator<D> pair_gradient(const VectorField<D>& X, const ScalarField& V,
                                              double spacing, int degree);

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

/// The weights γ of those rows, entry by entry as the gradient stores its own.
[[nodiscard]] std::vector<double> hourglass_weights(const Particles<2>& particles,
                                                    const VectorOperator<2>& gradient);

/// The cell stabiliser S = Aᵀ diag(κ) A, held by the rows it is made of and never multiplied out: a
/// third of the memory, and a direction more of G and D to whoever multiplies by those.
struct HourglassModes {
  std::vector<double> weights;  ///< A, entry by entry as those of the gradient
  ScalarField modulus;          ///< κ of each cell [Pa]

  [[nodiscard]] bool empty() const { return weights.empty(); }
};

/// Aᵀ diag(κ) A for rows A; κ [Pa] a value per cell.
[[nodiscard]] SparseMatrix normal_matrix(const SparseMatrix& rows, const ScalarField& kappa);

}  // namespace tlsph

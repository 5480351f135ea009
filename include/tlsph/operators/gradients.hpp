#pragma once
/// \file
/// The gradients of the formulations, as sparse matrices of the reference configuration.
///
/// Plain SPH sums (thesis section 2.6), V_q the volume [m^d] of node q:
///
///     W_pq = V_q W(|X_p − X_q|)          ⟨f⟩  = W f
///     X^a_pq = V_q ∂W/∂X_a (X_p − X_q)   ⟨∂f/∂X_a⟩ = X^a f
///
/// Corrected gradients are exact for linear fields: Σ_q G_pq = 0, Σ_q G^a_pq X^b_q = δ_ab.

#include "tlsph/kernels/families.hpp"
#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Corrections of a collocated gradient, Bonet & Lok (CMAME 180, 1999): `none` is the difference
/// form (40), `gradient` (42)–(45), `mixed` (54)–(58). `least_squares` fits a plane by moving least
/// squares instead: exact for linear fields too, and at boundaries its adjoint is several times
/// nearer to the divergence theorem, for it weighs with W where the others weigh with ∇W.
enum class Correction { none, gradient, mixed, least_squares };

/// Kernel matrix W (N×N) and plain gradient X at the nodes `X` (N×d) with volumes `V`; `h` is the
/// full support radius [m].
template <int D>
[[nodiscard]] SparseMatrix kernel_matrix(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                         const ScalarField& V);
template <int D>
[[nodiscard]] VectorOperator<D> plain_gradient(const AnyKernel& kernel, double h,
                                               const VectorField<D>& X, const ScalarField& V);

/// Collocated gradient with one of the corrections. InputError where a node has too few neighbours
/// for a linear fit.
template <int D>
[[nodiscard]] VectorOperator<D> collocated_gradient(const AnyKernel& kernel, double h,
                                                    const VectorField<D>& X, const ScalarField& V,
                                                    Correction correction);

/// Gradient at material points from the corners of their cell: the mean gradient over the cell,
/// G^a_sq = ½ (corner-difference vector)_a / area, which is exact for linear fields **and** whose
/// adjoint satisfies the divergence theorem exactly on any quadrilateral (Flanagan & Belytschko
/// 1981).
///
/// In 2D clouds the cell of an edge is the quadrilateral of the two triangles beside it (on the
/// boundary the one triangle), whose mean gradient it takes. These cells cover the body three
/// times, so Σ_s V_s G_s with thirds of their volumes is the sum over the triangles, and the
/// adjoint is as exact. Edges rather than the triangles themselves: the mean over the two sides of
/// an edge is of second order where the triangles are regular, that over one triangle is of first
/// (edge-based smoothed finite elements, Liu, Nguyen-Thoi & Lam 2009). Swinging plate on a
/// hexagonal lattice of 64 spacings a side: stress error 1.1e-3 at edges, 1.0e-2 at triangles,
/// order 1.6 and 1.0; jittered by 0.2: 3.9e-3 and 1.1e-2. Both lock as ν → 0.5, for they constrain
/// the volume at more points than half the degrees of freedom; a fit over a support
/// (`point_gradient`) and the consistent formulation do not.
template <int D>
[[nodiscard]] VectorOperator<D> cell_gradient(const Particles<D>& particles,
                                              const MaterialPoints<D>& points);

/// Gradient at material points by a moving-least-squares fit of a polynomial of degree `order` (1
/// or 2) over all nodes within `h` [m]: exact for polynomials of that degree. Weights W(r) without
/// volumes: half volumes at the boundary would undo the adjoint's balance
/// there (swinging plate, collocated, n = 32: stress error 1.6e-1 with them, 1.7e-2 without).
/// A point whose nodes within `h` do not determine the polynomial, as in the tip of a wedge, takes
/// those within up to 2.5 `h`; InputError where they do not either.
template <int D>
[[nodiscard]] VectorOperator<D> point_gradient(const AnyKernel& kernel, double h,
                                               const VectorField<D>& points,
                                               const VectorField<D>& X, int order = 1);

}  // namespace tlsph

#pragma once
/// \file
/// The consistency correction: a gradient whose adjoint is exact too.
///
/// A corrected SPH gradient G is exact for linear fields, but D = −GᵀV is not: nodal sums do not
/// satisfy the discrete divergence theorem near boundaries or on irregular particles, so that a
/// constant stress makes spurious forces, which excite modes that nothing damps. On irregular
/// particles the solution does not converge at all.
///
/// The correction is the smallest change δ of G on its own pattern, min Σ δ²/w, with
///
///     rows:     Σ_q (G+δ)^a_sq (X_q − X_s)^α = ∂_a (·)^α                 |α| ≤ k_r
///     columns:  Σ_s V_s (G+δ)^a_sq (X_s − X_q)^β = B^a_q [β=0] − V_q ∂_a(·)^β   |β| ≤ k_c
///
/// for every material point s and every node q, with B_q the lumped outward boundary area of a node
/// (zero inside). The rows say that G is exact for polynomials of degree k_r, the columns that GᵀV
/// is the exact weak divergence of a polynomial stress of degree k_c.
///
/// *Momenta.* Rows with k_r ≥ 1 give G·1 = 0 and G·X = I, so f = −∂U/∂u of an objective energy
/// keeps both momenta, whatever the columns say. *Constant stress.* Columns with k_c ≥ 0 give
/// D P + B P = 0 for constant P: tractions t = P N lumped with the same B are in equilibrium, to
/// rounding, on any cloud.
///
/// *The system.* With A the constraints on the entries of one direction, δ = w Aᵀλ and
/// (A w Aᵀ) λ = r: sparse, symmetric, positive semi-definite, with blocks for rows and columns that
/// couple where G has an entry. Lengths are divided by Δ, or it would be hopelessly scaled. A
/// handful of combinations of constraints vanish identically, one for each pair of a polynomial m
/// of degree k_c and p of degree k_r: both sets contain ∫ m ∂p + ∫ p ∂m = ∮ n m p. They are known
/// in closed form and taken out; as many constraints are pinned to make the matrix definite, and a
/// few steps of conjugate gradients with its factor bring the residual to rounding. One symbolic
/// analysis serves all directions. Compatible only if the quadrature is: Σ_s V_s m ∂_a p + Σ_q V_q
/// p ∂_a m = Σ_q B^a_q m p for all m, p of degrees k_c, k_r, which with_exact_moments(…) of
/// particles/moments.hpp provides for collocated operators: volumes exact to degree k_r + k_c − 1,
/// boundary areas to k_r + k_c.
///
/// *Where the quadrature errs.* That much makes the system solvable, not δ small. Take smooth m and
/// p: the constraints ask Σ_s V_s (m G p + p G m) = Σ_q B_q m p, so what V lacks of ∫ ∂(m p), an
/// h² of third derivatives, has to come from the third moments Σ_q δ (X_q − X_s)³ with rows of
/// degree two in the way. They can match one that is the same everywhere, as that of a trapezoidal
/// rule, but not one that varies: if volumes are made exact by a polynomial spread over the body,
/// δ grows as 1/h, the critical step falls as h² and accuracy goes. For degrees (2, 1) each
/// neighbourhood is therefore exact by itself (operators/local_volumes.hpp,
/// particles/boundary_runs.hpp). δ then does not depend on h, and on a lattice the solution
/// converges with order three.
///
/// *Cost.* In 2D (1, 1) has six unknowns a particle, (2, 1) nine; the factor grows as N log N, the
/// operations as N^(3/2). One factorisation a direction at set-up, nothing in a step: the pattern
/// of G is what it was. `consistency_cost` foretells it, `tlsph plan` prints that.

#include "tlsph/core/error.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

struct ConsistencyDegrees {
  int rows = 1;     ///< k_r: of the polynomials G is exact for
  int columns = 0;  ///< k_c: of the stresses its adjoint is exact for
};

/// What is left of the constraints, lengths in units of Δ.
struct ConsistencyResiduals {
  double row = 0.0;     ///< largest |Σ G (X_q − X_s)^α − ∂(·)^α|
  double column = 0.0;  ///< largest |Σ V G (X_s − X_q)^β − B [β=0] + V ∂(·)^β|
  double change = 0.0;  ///< largest |δ|, in units of 1/Δ
};

template <int D>
struct ConsistentGradient {
  VectorOperator<D> gradient;
  ConsistencyResiduals residuals;
};

/// The corrected gradient (M×N); `points` are the rows of `gradient`, the particles its columns.
/// InputError, at `place`, where residuals above 1e-8 are left: the quadrature is not compatible,
/// or the support leaves too little freedom.
template <int D>
[[nodiscard]] ConsistentGradient<D> consistent_gradient(const VectorOperator<D>& gradient,
                                                        const MaterialPoints<D>& points,
                                                        const Particles<D>& particles,
                                                        ConsistencyDegrees degrees,
                                                        const Place& place = {});

/// The cost of the factorisation behind `consistent_gradient`, once for each direction, from its
/// symbolic analysis; `bytes` holds the constraints and their matrix too.
template <int D>
[[nodiscard]] FactorCost consistency_cost(const VectorOperator<D>& gradient,
                                          const MaterialPoints<D>& points,
                                          const Particles<D>& particles,
                                          ConsistencyDegrees degrees);

}  // namespace tlsph

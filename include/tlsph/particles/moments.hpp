#pragma once
/// \file
/// Quadrature by particles: node volumes and the shares of boundary faces changed as little as
/// possible, so that they integrate polynomials exactly over the body:
///
///     Σ_q V_q X_q^β = ∫ X^β dV             |β| ≤ volume degree
///     Σ_f Σ_k share_fk n_f X_fk^β = ∮ n X^β dA    |β| ≤ boundary degree
///
/// These are the conditions under which a gradient can be exact for polynomials and its adjoint too
/// (operators/consistency.hpp): the sum over both is integration by parts.

#include "tlsph/core/error.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

struct QuadratureDegrees {
  int volume = 0;
  int boundary = 0;
};

/// The particles with volumes V, shares of all faces and area vectors B corrected, by the weighted
/// least change: Σ δV²/V and Σ |n_f| δshare². Cells and positions stay. The body is what the faces
/// enclose, or `shape` where the particles follow its boundary: nodes on a circle cannot integrate
/// exactly over the polygon between them, for on them x² + y² is a constant. InputError, at
/// `place`, where a volume would not stay positive, or the conditions cannot be met: too few
/// particles, or a boundary that is not closed (cell-centred placement).
template <int D>
[[nodiscard]] Particles<D> with_exact_moments(Particles<D> particles, QuadratureDegrees degrees,
                                              const Shape<D>* shape = nullptr,
                                              const Place& place = {});

/// Exponents β of the monomials X^β with |β| ≤ degree, by degree, x^k first.
template <int D>
[[nodiscard]] std::vector<std::array<int, D>> monomials(int degree);

/// X^β of all those.
template <int D>
[[nodiscard]] Eigen::VectorXd monomial_values(const std::vector<std::array<int, D>>& exponents,
                                              const Vector<D>& X);

}  // namespace tlsph

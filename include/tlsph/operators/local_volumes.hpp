#pragma once
/// \file
/// Node volumes that are exact for quadratic polynomials from their neighbourhood alone.

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Reach of the fits, in spacings: a quadratic needs second neighbours.
inline constexpr double volume_support = 2.6;

/// V_q = Σ_g w_g φ_q(X_g) [m^d] over the points g of a quadrature of the cells or triangles and of
/// the segments between chords and a curved boundary, with φ the moving least-squares interpolation
/// of degree two: Σ_q V_q f(X_q) = ∫ f over the cells for any quadratic f, and the error of others
/// is made where they are not, not spread over the body. Near nodes whose volume would fall below a
/// twentieth of that of their share of the cells φ is the (bi)linear interpolation in the cell.
/// Particles without either keep the volumes they have.
template <int D>
[[nodiscard]] ScalarField local_volumes(const Particles<D>& particles);

}  // namespace tlsph

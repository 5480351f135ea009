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
/// is made where they are not, not spread over the body. Each volume lies between 0.44 and 1.4 of
/// what the particle has (the part of the cells that is nearest to it); on a lattice all do by
/// themselves, 0.448 at the corners of a box. Elsewhere the φ change as little as that takes,
/// min Σ_g w_g Σ_q δφ_gq²/k_gq with k the kernel: they stay exact, so what a corner gains its
/// neighbourhood gives. Bounds that cannot be met widen in steps, to a tenth and ten. Particles
/// without cells and triangles keep the volumes they have.
template <int D>
[[nodiscard]] ScalarField local_volumes(const Particles<D>& particles);

}  // namespace tlsph

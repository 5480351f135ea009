#pragma once
/// \file
/// The inverse of a law in uniaxial stretch, ε̄ = P⁻¹(t̄) of a loaded boundary.

#include "tlsph/materials/any_law.hpp"

namespace tlsph {

/// H_11 [–], all other components of H zero, at which P_11 = traction [Pa], on the branch that
/// starts at the undeformed state and along which ∂P_11/∂F_11 > 0. Throws InputError if that branch
/// ends before the traction is reached (St Venant–Kirchhoff in compression, a nearly incompressible
/// Neo-Hookean body in 1D strain under tension).
template <int D>
[[nodiscard]] double uniaxial_gradient(const AnyLaw<D>& law, double traction);

}  // namespace tlsph

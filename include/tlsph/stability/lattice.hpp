#pragma once
/// \file
/// What a lattice of particles is far from its boundary.

#include "tlsph/analysis/lattice_symbol.hpp"
#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// What the linearised forces make of a push at the middle of a lattice that is so large that its
/// boundary does not matter there.
template <int D>
[[nodiscard]] LatticeSymbol<D> lattice_symbol(const Discretisation<D>& body, const State<D>& state);

}  // namespace tlsph

#pragma once
/// \file
/// Waves of a method on the undeformed lattice, far from any boundary.

#include "specimen.hpp"
#include "tlsph/analysis/lattice_symbol.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// What the linearised forces make of a push at the middle of a lattice that is so large that its
/// boundary does not matter there. The node there has all its neighbours in `specimen`.
template <int D>
[[nodiscard]] LatticeSymbol<D> lattice_symbol(const Discretisation<D>& disc, const State<D>& state);

/// Dispersion, its anisotropy and the waves without energy.
template <int D>
[[nodiscard]] WaveRow wave_row(const Subject& subject, const Method& method, double poisson);

}  // namespace tlsph

#pragma once
/// \file
/// The operators of an unbounded lattice: the same few weights for every particle.

#include <array>
#include <vector>

#include "tlsph/kernels/families.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Offsets of a kernel's support on the lattice, with weights normalised so that W sums to one and
/// X is exact for linear fields in the interior.
template <int D>
struct LatticeStencil {
  std::vector<std::array<int, D>> offset;
  std::vector<double> value;        ///< of W, dimensionless
  std::vector<Vector<D>> gradient;  ///< of X [1/m]
  int reach = 0;                    ///< largest offset in any direction
};
template <int D>
[[nodiscard]] LatticeStencil<D> lattice_stencil(const AnyKernel& kernel, double support,
                                                const LatticeFrame<D>& frame);

}  // namespace tlsph

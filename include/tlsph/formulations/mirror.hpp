#pragma once
/// \file
/// The `mirror` formulation: fields extended beyond the box by reflection, the ghosts eliminated
/// into the matrices once. No ghosts at run time, order 2, tractions exact at the loaded particles.

#include "tlsph/formulations/extension.hpp"
#include "tlsph/operators/lattice_stencil.hpp"
#include "tlsph/operators/vector_operator.hpp"

namespace tlsph {

/// Operators with their boundary terms.
template <int D>
struct FoldedOperators {
  VectorOperator<D> gradient;              ///< G, N×N
  VectorOperator<D> divergence;            ///< D = V X, N×N
  std::vector<SignalTerm> gradient_terms;  ///< into H, slot = node·d² + component
  std::vector<SignalTerm> force_terms;     ///< into f, slot = node·d + component
  std::vector<SignalTerm> stress_values;   ///< P at these slots **is** weight · signal
};

/// Folded gradient and force operator of a box; `V` are the node volumes. InputError if the box is
/// thinner than the stencil reaches.
template <int D>
[[nodiscard]] FoldedOperators<D> folded_operators(const LatticeStencil<D>& stencil,
                                                  const LatticeFrame<D>& frame,
                                                  const ScalarField& V, const Edges<D>& edges,
                                                  TractionGhost ghost);

}  // namespace tlsph

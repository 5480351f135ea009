#pragma once
/// \file
/// How fields go on beyond the edges of a box: the images that ghost particles stand for, and the
/// operators of the `mirror` formulation, which has them eliminated.
///
/// Across an edge with normal direction b at distance d, a displacement component that is
/// prescribed there is odd about its value, u(ghost) = 2ū − u(image); the normal component at a
/// traction edge keeps the strain ε̄ = P⁻¹(t̄) the load asks for, u(ghost) = u(image) ± 2d ε̄; all
/// else is even. Stress on the edge, P_ib, is odd about the traction where u_i is free (2t̄ − P, or
/// t̄ itself in the thesis's treatment) and even where it is prescribed. Beyond a symmetry edge the
/// shear components change sign, and beyond an antisymmetry edge the tangential normal stress does.

#include <array>

#include "tlsph/formulations/conditions.hpp"
#include "tlsph/operators/lattice_stencil.hpp"
#include "tlsph/operators/vector_operator.hpp"

namespace tlsph {

/// Index of no signal: the value is zero.
inline constexpr std::size_t no_signal = static_cast<std::size_t>(-1);

[[nodiscard]] inline double value_of(std::size_t signal, const std::vector<double>& signals) {
  return signal == no_signal ? 0.0 : signals[signal];
}

/// One edge of a box, all its components.
template <int D>
struct Edge {
  std::array<bool, D> prescribed{};         ///< displacement component given
  std::array<std::size_t, D> displacement;  ///< signal of its value
  bool symmetry = false;                    ///< the normal component is zero, the rest free
  bool antisymmetry = false;  ///< the tangential component is zero, the normal one free of load
  std::size_t traction = no_signal;  ///< normal traction [Pa]
  std::size_t gradient = no_signal;  ///< P⁻¹ of it
  Edge() { displacement.fill(no_signal); }
};

/// lower and upper edge of every direction.
template <int D>
using Edges = std::array<std::array<Edge<D>, 2>, D>;

/// The edges a node lies on or beyond: calls visit(edge, direction).
template <int D, class Visit>
void for_edges(const Edges<D>& edges, const LatticeFrame<D>& frame, const std::array<int, D>& at,
               const Visit& visit) {
  for (std::size_t b = 0; b < D; ++b) {
    if (at[b] <= 0) visit(edges[b][0], static_cast<int>(b));
    if (at[b] >= frame.counts[b] - 1) visit(edges[b][1], static_cast<int>(b));
  }
}

/// A ghost value: sign · (value at node) + Σ weight · signal.
struct Image {
  Index node = 0;
  double sign = 1.0;
  struct Term {
    std::size_t signal;
    double weight;
  };
  std::array<Term, 4> terms{};
  std::size_t count = 0;

  void add(std::size_t signal, double weight) {
    if (signal != no_signal) terms[count++] = {signal, sign * weight};
  }
};

/// What a stress ghost beyond a traction edge is: the mirror image 2t̄ − P, or the target t̄.
enum class TractionGhost { mirrored, target };

/// Image of displacement component i at lattice coordinates `at` (may lie outside the box by at
/// most its own width).
template <int D>
[[nodiscard]] Image displacement_image(const LatticeFrame<D>& frame, const Edges<D>& edges,
                                       std::array<int, D> at, int i);
/// The operators of `mirror`, with their boundary terms: fields extended beyond the box by
/// reflection, the ghosts eliminated into the matrices once. No ghosts at run time, order 2,
/// tractions exact at the loaded particles.
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

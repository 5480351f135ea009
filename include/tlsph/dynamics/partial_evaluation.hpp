#pragma once
/// \file
/// Evaluates H, P and f for a few nodes and points only, as probes need them.

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// The rows of H, P and f that belong to a few nodes and material points; for discretisations that
/// a sweep can step (sweep/sweep.hpp).
template <int D>
class PartialEvaluation {
 public:
  /// `nodes` whose force and `points` whose strain and stress are wanted, in any order.
  PartialEvaluation(const Discretisation<D>& discretisation, std::vector<Index> nodes,
                    std::vector<Index> points);

  /// Writes these rows of state.H, state.P, state.f (and state.viscous), with the very numbers that
  /// `evaluate` writes there; all others stay as they are. Takes nothing from the heap.
  void evaluate(const Discretisation<D>& discretisation, State<D>& state) const;

 private:
  struct NodeLoad {
    std::size_t load = 0;
    Index dof = 0;
    double weight = 0.0;
  };
  std::vector<Index> nodes_, points_;
  std::vector<std::size_t> region_;  // of each point
  std::vector<NodeLoad> loads_;
};

}  // namespace tlsph

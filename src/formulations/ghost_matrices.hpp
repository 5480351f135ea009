#pragma once
/// \file
/// Matrices over a lattice and its ghosts, and the edges these lie beyond.

#include <vector>

#include "tlsph/formulations/extension.hpp"
#include "tlsph/operators/lattice_stencil.hpp"
#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/ghosts.hpp"

namespace tlsph {

template <int D>
bool inside(const GhostLattice<D>& lattice, const std::array<int, D>& at) {
  for (std::size_t a = 0; a < D; ++a)
    if (at[a] < -lattice.layers || at[a] >= lattice.frame.counts[a] - lattice.layers) return false;
  return true;
}

/// Visits the neighbours of a lattice node that exist: visit(neighbour, index in the stencil).
template <int D, class Visit>
void for_stencil(const LatticeStencil<D>& stencil, const GhostLattice<D>& lattice, Index p,
                 const Visit& visit) {
  for (std::size_t k = 0; k < stencil.offset.size(); ++k) {
    auto at = lattice.coordinates[static_cast<std::size_t>(p)];
    for (std::size_t a = 0; a < D; ++a) at[a] += stencil.offset[k][a];
    if (inside<D>(lattice, at)) visit(lattice.node(at), k);
  }
}

template <int D>
SparseMatrix lattice_kernel(const LatticeStencil<D>& stencil, const GhostLattice<D>& lattice) {
  std::vector<Eigen::Triplet<double>> entries;
  const Index N = lattice.X.rows();
  for (Index p = 0; p < N; ++p)
    for_stencil<D>(stencil, lattice, p, [&](int q, std::size_t k) {
      entries.emplace_back(static_cast<int>(p), q, stencil.value[k]);
    });
  SparseMatrix W(N, N);
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

template <int D>
VectorOperator<D> lattice_gradient(const LatticeStencil<D>& stencil,
                                   const GhostLattice<D>& lattice) {
  const Index N = lattice.X.rows();
  std::array<std::vector<Eigen::Triplet<double>>, D> entries;
  for (Index p = 0; p < N; ++p)
    for_stencil<D>(stencil, lattice, p, [&](int q, std::size_t k) {
      for (std::size_t a = 0; a < D; ++a)
        entries[a].emplace_back(static_cast<int>(p), q, stencil.gradient[k][static_cast<Index>(a)]);
    });
  std::array<SparseMatrix, D> X;
  for (std::size_t a = 0; a < D; ++a) {
    X[a].resize(N, N);
    X[a].setFromTriplets(entries[a].begin(), entries[a].end());
  }
  return VectorOperator<D>(X);
}

/// The edges a node lies on or beyond: calls visit(edge, direction).
template <int D, class Visit>
void for_edges(const Edges<D>& edges, const LatticeFrame<D>& real, const std::array<int, D>& at,
               const Visit& visit) {
  for (std::size_t b = 0; b < D; ++b) {
    if (at[b] <= 0) visit(edges[b][0], static_cast<int>(b));
    if (at[b] >= real.counts[b] - 1) visit(edges[b][1], static_cast<int>(b));
  }
}

}  // namespace tlsph

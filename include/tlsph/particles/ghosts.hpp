#pragma once
/// \file
/// The lattice of an interval or box continued beyond its boundary.

#include <array>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Real nodes first, in the order of the particles, then ghosts in the order of the extended
/// lattice.
template <int D>
struct GhostLattice {
  LatticeFrame<D> frame;  ///< of the extended lattice: its node (0, 0) is real (−layers, −layers)
  int layers = 0;
  Index real = 0;                               ///< number of real nodes
  VectorField<D> X;                             ///< (real + ghosts)×d positions [m]
  std::vector<std::array<int, D>> coordinates;  ///< of every node; real ones in [0, counts)
  std::vector<int> lookup;                      ///< node of each row of the extended frame

  [[nodiscard]] Index ghosts() const { return X.rows() - real; }
  /// Node at lattice coordinates counted as for the real nodes, within `layers` of them.
  [[nodiscard]] int node(std::array<int, D> at) const {
    for (int& c : at) c += layers;
    return lookup[static_cast<std::size_t>(frame.index(at))];
  }
};

/// `layers` ≥ 0 further rows of nodes on every side, corners included. InputError, at `place`, if
/// the particles are no full lattice of an interval or box.
template <int D>
[[nodiscard]] GhostLattice<D> ghost_layers(const Particles<D>& particles, int layers,
                                           const Place& place = {});

}  // namespace tlsph

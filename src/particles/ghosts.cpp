#include "tlsph/particles/ghosts.hpp"

#include <fmt/core.h>

#include <limits>

namespace tlsph {
template <int D>
GhostLattice<D> ghost_layers(const Particles<D>& particles, int layers, const Place& place) {
  if (!particles.frame)
    throw InputError(place,
                     "ghost particles need a body that is a full interval or box without jitter");
  if (layers < 0)
    throw InputError(place, fmt::format("the number of ghost layers must be ≥ 0, not {}", layers));
  const LatticeFrame<D>& real = *particles.frame;
  double size = 1.0;  // may be more than an integer holds
  for (const int count : real.counts) size *= count + 2.0 * layers;
  if (size > std::numeric_limits<int>::max())
    throw InputError(place, fmt::format("{} ghost layers make {:.3g} particles, more than can be "
                                        "numbered",
                                        layers, size));

  GhostLattice<D> lattice;
  lattice.layers = layers;
  lattice.real = particles.size();
  lattice.frame = real;
  lattice.frame.origin = real.origin - static_cast<double>(layers) * real.spacing;
  for (int& count : lattice.frame.counts) count += 2 * layers;

  const int total = static_cast<int>(size);
  lattice.X.resize(total, D);
  lattice.X.topRows(lattice.real) = particles.X;
  lattice.coordinates.resize(static_cast<std::size_t>(total));
  lattice.lookup.resize(static_cast<std::size_t>(total));
  int ghost = static_cast<int>(lattice.real);
  for (int row = 0; row < total; ++row) {
    std::array<int, D> at = lattice.frame.coordinates(row);
    bool inside = true;
    for (std::size_t a = 0; a < D; ++a) {
      at[a] -= layers;
      inside = inside && at[a] >= 0 && at[a] < real.counts[a];
    }
    const int node = inside ? real.index(at) : ghost++;
    lattice.lookup[static_cast<std::size_t>(row)] = node;
    lattice.coordinates[static_cast<std::size_t>(node)] = at;
    if (inside) continue;
    for (int a = 0; a < D; ++a)
      lattice.X(node, a) = real.origin(a) + at[static_cast<std::size_t>(a)] * real.spacing(a);
  }
  return lattice;
}

template GhostLattice<1> ghost_layers(const Particles<1>&, int, const Place&);
template GhostLattice<2> ghost_layers(const Particles<2>&, int, const Place&);

}  // namespace tlsph

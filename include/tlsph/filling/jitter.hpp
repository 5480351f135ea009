#pragma once
/// \file
/// Lattices put in disorder, reproducibly.

#include <cstdint>

#include "tlsph/core/error.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Inner nodes (those in no boundary face) moved by share·Δ_a·r, r uniform in [−1, 1), per
/// coordinate. r comes from std::mt19937_64(seed), 53 bits per number, inner nodes of cells
/// by their places (first coordinate first), of clouds in their order, coordinates in theirs: the
/// same seed gives the same particles on every machine.
///
/// A quadrilateral that would lose its shape (a corner Jacobian ≤ 0.1 of the lattice's, possible
/// for shares above 0.225) has the moves of its corners halved until it keeps it, so cells stay
/// convex. Node volumes follow the cells (`node_volumes`); cell-centred volumes stay as they are.
/// (Voronoi volumes would take up to 5 % off the errors of the swinging plate with consistency
/// [1, 1] and 2 % with [2, 1], jitter 0.2, 16 to 64 cells a side; not worth masses that differ from
/// those of the cells.)
/// A cloud is held by its triangles in the same way (area > 0.1 of what it was), then triangulated
/// anew; its volumes stay Voronoi cells.
/// The frame is dropped unless share = 0. InputError, at `place`, unless 0 ≤ share ≤ 0.4.
template <int D>
[[nodiscard]] Particles<D> jittered(Particles<D> particles, double share, std::uint64_t seed,
                                    const Place& place = {});

}  // namespace tlsph

#pragma once
/// \file
/// Bodies for the counter-example: lattices under uniform stress whose kernel sums are rebuilt
/// every step.

#include <array>

#include "tlsph/contrast/growth.hpp"
#include "tlsph/contrast/updated_lagrangian.hpp"

namespace tlsph {

template <int D>
struct CurrentRun {
  CurrentBody<D> body;
  CurrentState<D> state;
};

/// `counts` particles a direction, the last coordinate fastest, at rest; `held` layers at each end
/// of each direction do not move.
template <int D>
[[nodiscard]] CurrentRun<D> current_lattice(const StressedLattice<D>& lattice,
                                            const std::array<int, D>& counts, int held);

/// Moves the particles by `displacement` [m] without motion: stress and density follow as in a
/// step.
template <int D>
void displace(CurrentRun<D>& run, const VectorField<D>& displacement);

/// Largest growth rate [1/s] of small motions of that very body, its held layers included: √ of the
/// rightmost eigenvalue of the derivative of its accelerations, which is symmetric for equal
/// masses.
template <int D>
[[nodiscard]] double linear_growth_rate(const CurrentRun<D>& run);

}  // namespace tlsph

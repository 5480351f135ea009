#pragma once
/// \file
/// Distance from an exact solution.

#include "tlsph/dynamics/state.hpp"
#include "tlsph/exact/exact.hpp"

namespace tlsph {

/// Relative L2 errors √(Σ V|a − b|²/Σ V|b|²) over all components: displacement and velocity at the
/// nodes, first Piola–Kirchhoff stress at the material points.
struct RelativeErrors {
  double displacement = 0.0;
  double velocity = 0.0;
  double stress = 0.0;
};

/// A field whose exact values vanish everywhere gives the absolute norm.
template <int D>
[[nodiscard]] RelativeErrors errors_against(const ExactSolution<D>& exact, const Instant<D>& now);

}  // namespace tlsph

#pragma once
/// \file
/// Where a material stops carrying waves (loss of hyperbolicity). A homogeneous state whose
/// acoustic tensor has an eigenvalue ρc² ≤ 0 cannot persist: any disturbance of it grows, the
/// shorter the faster, until the body has separated into other states. That is a property of the
/// law at this deformation; no method, spacing or time step avoids it, and what follows it depends
/// on all of them.

#include <optional>
#include <string>
#include <vector>

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// A material point beyond the limit.
struct HyperbolicityLoss {
  double time = 0.0;                 ///< [s]
  Index point = -1;                  ///< number of the material point
  std::vector<double> position;      ///< of it in the reference configuration [m]
  std::vector<double> stretches;     ///< principal ones, the largest first
  double acoustic_eigenvalue = 0.0;  ///< ρc² of its slowest plane wave [Pa], not positive

  /// What happened, in words, for people.
  [[nodiscard]] std::string text() const;
};

/// The material point furthest beyond the limit, nothing if every one carries waves. Points of laws
/// that are linear in H always do and are not looked at.
template <int D>
[[nodiscard]] std::optional<HyperbolicityLoss> most_unstable_point(
    const Discretisation<D>& discretisation, const State<D>& state);

}  // namespace tlsph

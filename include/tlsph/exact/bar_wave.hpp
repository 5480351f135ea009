#pragma once
/// \file
/// Plane longitudinal wave in a linear elastic bar by d'Alembert, all reflections included.

#include "tlsph/curves/curve.hpp"
#include "tlsph/exact/exact.hpp"

namespace tlsph {

/// A bar at rest on [lower, lower + length], loaded on one end from t = 0 on.
struct BarWave {
  enum class Side { lower, upper };
  enum class Support { fixed, free };

  double lower = 0.0;    ///< coordinate of the lower end [m]
  double length = 0.0;   ///< [m]
  double modulus = 0.0;  ///< P_xx = modulus · ∂u/∂x [Pa]: `p_modulus` of the kinematics
  double lateral_modulus = 0.0;  ///< P_yy = lateral modulus · ∂u/∂x [Pa], 2D only
  double density = 0.0;          ///< [kg/m³]
  Curve traction;                ///< normal component on the loaded end [Pa], tension positive
  Side loaded = Side::lower;
  Support far_end = Support::fixed;
};

/// With ξ the distance from the loaded end, c = √(modulus/density), Z = density · c, p the traction
/// and I its integral, the outward wave has the displacement −I(t − ξ/c)/Z along ξ and the stress
/// p(t − ξ/c). A fixed end sends it back with opposite displacement and equal stress, a free end
/// (and the loaded one, for what comes back to it) with equal displacement and opposite stress.
///
/// In 2D the wave runs along x with no lateral motion; that is P_yy = λ ∂u/∂x in plane strain, the
/// reduced λ in plane stress. Throws InputError unless length, modulus and density are positive.
/// D is 1 or 2.
template <int D>
[[nodiscard]] ExactSolution<D> bar_wave(const BarWave& bar);

}  // namespace tlsph

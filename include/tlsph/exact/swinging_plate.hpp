#pragma once
/// \file
/// A standing shear wave in a square plate with sliding edges, after Lee et al.'s swinging cube.

#include "tlsph/exact/exact.hpp"

namespace tlsph {

/// The square [corner, corner + length]² whose normal displacement is fixed on the lower edges and
/// whose tangential displacement is fixed on the upper ones. Linear elastic; the motion keeps
/// volume, so it is the same in plane strain and plane stress.
struct SwingingPlate {
  Vector<2> corner = Vector<2>::Zero();  ///< [m]
  double length = 1.0;                   ///< [m]
  double shear_modulus = 0.0;            ///< μ [Pa]
  double density = 0.0;                  ///< [kg/m³]
  double amplitude = 0.0;                ///< U₀ [m]
};

/// ω = (π/2L) √(2μ/ρ) [rad/s].
[[nodiscard]] double swinging_plate_frequency(const SwingingPlate& plate);

/// u = U₀ cos(ωt) [−sin(kX) cos(kY), cos(kX) sin(kY)] with k = π/(2L) and X, Y from the corner.
/// P = 2μ sym ∇u, as div u = 0. Throws InputError unless length, shear modulus and density are
/// positive.
[[nodiscard]] ExactSolution<2> swinging_plate(const SwingingPlate& plate);

}  // namespace tlsph

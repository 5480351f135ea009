#pragma once
/// \file
/// The exact solutions and initial fields that a scene can name. D is 1 or 2; InputError for
/// lengths, moduli or densities that are not positive.

#include "tlsph/curves/curve.hpp"
#include "tlsph/exact/exact.hpp"
#include "tlsph/materials/any_law.hpp"

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

/// d'Alembert's wave, all reflections included. With ξ the distance from the loaded end, c =
/// √(modulus/density), Z = density · c, p the traction and I its integral, the outward wave has the
/// displacement −I(t − ξ/c)/Z along ξ and the stress p(t − ξ/c). A fixed end sends it back with
/// opposite displacement and equal stress, a free end (and the loaded one, for what comes back to
/// it) with equal displacement and opposite stress.
///
/// In 2D the wave runs along x with no lateral motion; that is P_yy = λ ∂u/∂x in plane strain, the
/// reduced λ in plane stress.
template <int D>
[[nodiscard]] ExactSolution<D> bar_wave(const BarWave& bar);

/// A standing shear wave after Lee et al.'s swinging cube: the square [corner, corner + length]²,
/// its normal displacement fixed on the lower edges, its tangential displacement on the upper ones.
/// Linear elastic; the motion keeps volume, so it is the same in plane strain and plane stress.
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
/// P = 2μ sym ∇u, as div u = 0.
[[nodiscard]] ExactSolution<2> swinging_plate(const SwingingPlate& plate);

/// The body between x = fixed_end and x = fixed_end + length, its far end moved along x so slowly
/// that it stays homogeneous.
struct UniformStretch {
  double fixed_end = 0.0;  ///< [m]
  double length = 0.0;     ///< [m], reference; negative if the fixed end is the upper one
  Curve elongation;        ///< displacement of the far end along x [m]
};

/// u_x = elongation(t) (X − fixed_end)/length and no lateral motion: H_xx = elongation/length, P
/// from the law. Quasi-static: exact where the load is slow against the wave transit.
template <int D>
[[nodiscard]] ExactSolution<D> uniform_stretch(const UniformStretch& stretch, const AnyLaw<D>& law);

/// κ = kL of the first bending mode of a clamped–free beam, cos κ cosh κ = −1.
inline constexpr double cantilever_wave_number = 1.875104068711961;

/// First Euler–Bernoulli mode of a beam clamped at ξ = 0 and free at ξ = 1 (ξ = x/L), scaled to 1
/// at the free end: φ = ½ [cosh κξ − cos κξ − σ (sinh κξ − sin κξ)], σ = (cosh κ + cos κ)/(sinh κ +
/// sin κ).
[[nodiscard]] double cantilever_mode(double xi);

}  // namespace tlsph

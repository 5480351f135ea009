#pragma once
/// \file
/// A wave that runs one way through a nonlinear bar at rest, exactly, until it breaks.

#include "tlsph/curves/curve.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/observe/history.hpp"

namespace tlsph {

/// With c(H) = √((dP/dH)/ρ) and m(H) = ∫₀ᴴ c dH', the bar ρ u_tt = P_X carries v − m unchanged
/// along dX/dt = c and v + m along dX/dt = −c. Where nothing comes back v = −m, and each state
/// leaves the end X = 0 with the speed c of its own: P(X, τ + X/c) = p(τ).
class SimpleWave {
 public:
  /// Load p(τ) [Pa] at X = 0, followed for τ in [0, duration] s; density in kg/m³.
  SimpleWave(AnyLaw<1> law, double density, Curve load, double duration);

  /// c [m/s] at the displacement gradient H.
  [[nodiscard]] double speed(double H) const;
  /// m [m/s].
  [[nodiscard]] double invariant(double H) const;
  /// H with m(H) = value.
  [[nodiscard]] double gradient_of(double value) const;
  /// H = P⁻¹(traction).
  [[nodiscard]] double gradient_under(double traction) const;
  [[nodiscard]] double stress(double H) const;

  /// Where two states meet first and the wave breaks [m]: the least of c²/(dc/dτ).
  [[nodiscard]] double breaking_distance() const;
  /// Columns `stress` [Pa] and `velocity` [m/s] at X [m] before the wave breaks, at the times when
  /// evenly loaded states arrive.
  [[nodiscard]] History history(double X) const;

 private:
  AnyLaw<1> law_;
  double density_;
  Curve load_;
  double duration_;
};

}  // namespace tlsph

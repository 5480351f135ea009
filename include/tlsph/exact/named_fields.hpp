#pragma once
/// \file
/// Initial fields a scene can name.

namespace tlsph {

/// κ = kL of the first bending mode of a clamped–free beam, cos κ cosh κ = −1.
inline constexpr double cantilever_wave_number = 1.875104068711961;

/// First Euler–Bernoulli mode of a beam clamped at ξ = 0 and free at ξ = 1 (ξ = x/L), scaled to 1
/// at the free end: φ = ½ [cosh κξ − cos κξ − σ (sinh κξ − sin κξ)], σ = (cosh κ + cos κ)/(sinh κ +
/// sin κ).
[[nodiscard]] double cantilever_mode(double xi);

/// dφ/dξ.
[[nodiscard]] double cantilever_mode_slope(double xi);

}  // namespace tlsph

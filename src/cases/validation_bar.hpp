#pragma once
/// \file
/// The validation bar of the thesis, sec. 4.6.3.1, in 1D strain, and the load on it.

#include <array>

#include "tlsph/materials/waves.hpp"

namespace tlsph::validation_bar {

inline constexpr double length = 0.15;     ///< [m]
inline constexpr double young = 200e9;     ///< [Pa]
inline constexpr double poisson = 0.3;     ///< taken from sec. 5.3.1
inline constexpr double density = 8000.0;  ///< [kg/m³]
inline constexpr double pressure = 100e3;  ///< of the pulse [Pa]
inline constexpr double duration = 8e-6;   ///< of the pulse [s]
/// Those it is computed with.
inline constexpr std::array formulations = {"thesis", "mirror", "stress-point", "variational"};
/// c_L = √((λ + 2μ)/ρ) = 5801 m/s.
inline const double speed = wave_speed(p_modulus(1, Assumption::strain, young, poisson), density);

}  // namespace tlsph::validation_bar

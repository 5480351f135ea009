#pragma once
/// \file
/// What a formulation shows to whoever steps it, whatever its unknowns are: {u, v}, or momentum and
/// deformation gradient, or more.

#include <concepts>

namespace tlsph {

/// Unknowns y with ẏ = r(t, y).
///
/// - `State` holds y, and may hold what follows from it, which `rate` brings up to date; a copy of
///   it goes on like the original. `Rate` holds ẏ.
/// - `rate(t, state, out)` is r(t, y) [1/s]; it imposes what is prescribed at t, and throws
///   NumericalError where the state has no stress. Into the same `out` it takes nothing from the
///   heap after the first time.
/// - `add(h, rate, state)` is y += h ẏ.
/// - `energy(state)` [J per thickness], kinetic and elastic, after `rate`.
template <class Motion>
concept EquationOfMotion = std::copyable<typename Motion::State> &&
    std::default_initializable<typename Motion::Rate> &&
    requires(const Motion& motion, typename Motion::State& state, typename Motion::Rate& rate,
             double t) {
  motion.rate(t, state, rate);
  motion.add(t, rate, state);
  { motion.energy(state) } -> std::same_as<double>;
};

}  // namespace tlsph

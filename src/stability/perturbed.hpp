#pragma once
/// \file
/// What runs say of a state. The forces of the uniform state are taken off, as dead loads would do,
/// so that it is one of equilibrium whatever its operators make of it, and what moves is the
/// perturbation.

#include "spectrum.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// Displaced by 1e-10 Δ at random and left to itself at steps of `dt` [s], until the body is lost
/// or for as long as the growth that the spectrum expects would take.
template <int D>
[[nodiscard]] PerturbedRun perturbed_run(const Specimen<D>& specimen, const StateSpectrum& spectrum,
                                         double dt, const std::string& label);

/// Largest change of the energy over the first of a run at random velocities of 1e-3 c_p, 300 steps
/// of `dt`; only what is gained where a viscosity takes energy. The run may throw NumericalError.
template <int D>
[[nodiscard]] double energy_drift(const Specimen<D>& specimen, double dt);

/// Largest speed over c_p in 200 steps of the uniform state, left to itself without the dead loads
/// that balance it; infinite where it is lost.
template <int D>
[[nodiscard]] double unrest(const Specimen<D>& specimen, double dt);

/// Largest displacement of a free body over two periods of the first true vibration `omega` [1/s],
/// started in the mode of the least energy that is no rigid motion, over what that velocity would
/// make of the first vibration: about one, or many times that for a mode without energy.
template <int D>
[[nodiscard]] double free_excursion(const Specimen<D>& specimen, double dt, double omega);

}  // namespace tlsph

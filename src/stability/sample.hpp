#pragma once
/// \file
/// The body of one state, uniformly stretched in the first direction: its operators, its spectrum,
/// and its runs.

#include <complex>
#include <filesystem>
#include <string>
#include <vector>

#include "method.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/scene/scene.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// The scene of an atlas, read once: its file may change while hundreds of states are computed.
struct Subject {
  Scene scene;  ///< small and bare
  int dimension = 2;
  bool box = true;                   ///< a full interval or box, whose edges can slide
  double spacing = 0.0;              ///< [m]
  std::vector<double> lower, upper;  ///< of the body [m]
  double poisson = 0.3, young = 1.0, density = 1.0;
};

/// Reads the scene, checks that an atlas can be drawn of it, and coarsens it to a few hundred
/// particles at the most.
[[nodiscard]] Subject read_subject(const std::filesystem::path& file,
                                   const std::vector<std::string>& overrides);

/// `sliding`: the normal displacement of each edge of a box is held at that of the stretch, so that
/// the uniform state of a material that carries waves is stable (van Hove; other shapes are held
/// all around). `free`: nothing is held.
enum class Support { sliding, free };

/// The edges of a box slide along themselves; the right one moves along x.
[[nodiscard]] std::vector<BoundaryScene> sliding_edges(int dimension, const Curve& right);

/// The scene of a state.
[[nodiscard]] Scene scene_of(const Subject& subject, const StateKey& key, Support support);

template <int D>
struct Sample {
  Discretisation<D> body;
  Tensor<D> H0 = Tensor<D>::Zero();  ///< the uniform displacement gradient
  State<D> state;                    ///< at rest at H0, evaluated
};
/// InputError where the operators cannot be built, NumericalError where the uniform state is none.
template <int D>
[[nodiscard]] Sample<D> build_sample(const Subject& subject, const StateKey& key, Support support);

/// The whole spectrum of M⁻¹K, dense.
struct StateSpectrum {
  std::vector<std::complex<double>> squares;  ///< ω², largest modulus first [1/s²]
  double bound = 0.0;                         ///< critical step as a run computes it [s]
  double limit = 0.0;  ///< the true one: 2/ω_max, or with viscosity λ_max(Δt²K + 2ΔtC) = 4 [s]
  double growth = 0.0;  ///< largest Re(s) [1/s], zero where it is round-off
  Index negative = 0;   ///< ω² < 0 beyond round-off
  /// The unit of the steps of runs: the bound or, where a material without waves has no sensible
  /// one, the step in which its fastest growth is resolved.
  [[nodiscard]] double critical() const {
    return bound > 0.0 && bound < 1.1 * limit ? bound : limit;
  }
  /// How many |ω²| are below `square`, and the `count`-th smallest |ω²| from zero on [1/s²].
  [[nodiscard]] Index below(double square) const;
  [[nodiscard]] double smallest(Index count) const;
};
template <int D>
[[nodiscard]] StateSpectrum spectrum_of(const Sample<D>& sample);

// Runs of a state. The forces of the uniform state are taken off, as dead loads would do, so that
// it is one of equilibrium whatever its operators make of it, and only the perturbation moves.

/// Displaced by 1e-10 Δ at random, steps of `dt` [s], until the body is lost or for as long as the
/// growth that the spectrum expects would take.
template <int D>
[[nodiscard]] PerturbedRun perturbed_run(const Sample<D>& sample, const StateSpectrum& spectrum,
                                         double dt, const std::string& label);

/// Largest change of the energy over the first of a run at random velocities of 1e-3 c_p, 300 steps
/// of `dt`; only what is gained where a viscosity takes energy. The run may throw NumericalError.
template <int D>
[[nodiscard]] double energy_drift(const Sample<D>& sample, double dt);

/// Largest speed over c_p in 200 steps of the uniform state without the dead loads that balance it;
/// infinite where it is lost.
template <int D>
[[nodiscard]] double drift_at_rest(const Sample<D>& sample, double dt);

/// Largest displacement of a free body over two periods of the first true vibration `omega` [1/s],
/// started in the mode of the least energy that is no rigid motion, over what that velocity would
/// make of the first vibration: about one, or many times that for a mode without energy.
template <int D>
[[nodiscard]] double free_excursion(const Sample<D>& sample, double dt, double omega);

}  // namespace tlsph

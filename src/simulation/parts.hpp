#pragma once
/// \file
/// The parts `build` is made of; not for other rooms.

#include "tlsph/boundary/extension.hpp"
#include "tlsph/dynamics/critical_step.hpp"
#include "tlsph/simulation/builder.hpp"
#include "tlsph/simulation/summary.hpp"

namespace tlsph::parts {

/// Laws and densities with the points they hold, and the masses of the nodes.
template <int D>
void add_materials(const Scene& scene, Discretisation<D>& disc);

/// Constraints and loads from the scene's boundaries, and inverse masses.
template <int D>
void add_conditions(const Scene& scene, Discretisation<D>& disc);

/// The loads of the scene's boundaries, in their order.
template <int D>
[[nodiscard]] std::vector<LoadedPatch> loaded_patches(const Scene& scene,
                                                      const Discretisation<D>& disc);

/// What the results of the scene suffer from though it runs, a sentence each.
template <int D>
[[nodiscard]] std::vector<std::string> warnings(const Scene& scene, const Discretisation<D>& disc);

/// The edges of a box as `mirror` and `thesis` need them; adds their signals.
template <int D>
[[nodiscard]] Edges<D> build_edges(const Scene& scene, Discretisation<D>& disc);

/// S or C of the scene's stabiliser.
template <int D>
void add_stabiliser(const Scene& scene, Discretisation<D>& disc);

/// InputError for a body that starts under a uniform stress which its supports and loads balance,
/// while its operators do not: near boundaries the adjoint of a corrected gradient breaks the
/// divergence theorem, and what a run would show is the energy of that. `displacement` is the
/// initial one of the whole body, before any region of it.
template <int D>
void refuse_imbalance(const Scene& scene, const Discretisation<D>& disc,
                      const VectorField<D>& displacement);

/// What is prescribed at t = 0 and is not where or as fast as the body starts, a sentence each with
/// place, key, amount and the stress that the jump makes.
template <int D>
[[nodiscard]] std::vector<std::string> start_jumps(const Scene& scene,
                                                   const Discretisation<D>& disc,
                                                   const InitialState<D>& initial);

/// The step a run of the scene starts with [s]: time.step, or its share of the critical step at the
/// start. InputError for a time.step beyond what is stable, unless the scene allows it, and for
/// more steps than a run could make.
[[nodiscard]] double chosen_step(const Scene& scene, const CriticalStep& critical);

/// The material entry that rules at X: the last one whose box holds it, else the first, which has
/// no box.
template <int D>
[[nodiscard]] std::size_t material_at(const Scene& scene, const Vector<D>& X, double tolerance);

/// Axis a patch is perpendicular to. InputError if it is no straight axis-aligned edge.
template <int D>
[[nodiscard]] int normal_axis(const Patch<D>& patch, const Place& place);

}  // namespace tlsph::parts

#pragma once
/// \file
/// From what a scene says to what a run needs: particles, regions, conditions, operators.

#include "tlsph/exact/exact.hpp"
#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Particles of the scene's body, with its named boxes and its jitter. InputError when their
/// estimated memory exceeds the machine's, or when the body cannot be divided as asked.
template <int D>
[[nodiscard]] Particles<D> build_particles(const Scene& scene);

/// Whether gradients are corrected to the degrees the scene asks for, or left as they are fitted: a
/// plan looks at what the correction would cost.
enum class Gradients { corrected, fitted };

/// Everything a run needs. InputError, with the place in the scene, for what cannot be modelled.
template <int D>
[[nodiscard]] Discretisation<D> build(const Scene& scene,
                                      Gradients gradients = Gradients::corrected);

/// Displacement and velocity at t = 0 (N×d).
template <int D>
struct InitialState {
  VectorField<D> displacement;
  VectorField<D> velocity;
};
template <int D>
[[nodiscard]] InitialState<D> build_initial(const Scene& scene,
                                            const Discretisation<D>& discretisation);

/// The exact solution the scene names; empty functions if none.
template <int D>
[[nodiscard]] ExactSolution<D> build_exact(const Scene& scene,
                                           const Discretisation<D>& discretisation);

/// What an entry does to the patch it names; InputError for symmetry where that is no straight edge
/// along an axis.
template <int D>
[[nodiscard]] std::vector<Condition> conditions_on(const Patch<D>& patch,
                                                   const BoundaryScene& entry);
/// The forces of a condition that loads its patch.
template <int D>
[[nodiscard]] Load load_of(const Patch<D>& patch, const Condition& condition);

/// Bytes a run of so many particles needs at its peak, an estimate by formulation and support: of
/// its operators and fields, those that follow the step of a deforming body included, and of the
/// factor behind a correction of the gradient.
[[nodiscard]] double operator_bytes(const Scene& scene, double particles);
[[nodiscard]] double correction_bytes(const Scene& scene, double particles);
/// Bytes of memory this machine has.
[[nodiscard]] double machine_bytes();

}  // namespace tlsph

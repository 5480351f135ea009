#pragma once
/// \file
/// Suggestions for a cheaper scene, one line each with the saving; empty if there is none.

#include <string>

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph::savings {

/// A dimension nothing depends on; else a plane of symmetry that is not used. `particles` of the
/// scene as it is.
[[nodiscard]] std::string of_reduction(const Scene& scene, Index particles);

/// The largest strain or rotation the scene can be expected to cause, an estimate on the safe side
/// from its loads, its prescribed motions and its start: of a slender body as if it bent.
[[nodiscard]] double strain_estimate(const Scene& scene);

/// Laws differ by about three times the strain: below this, by less than a run resolves.
inline constexpr double small_strain = 1e-4;

/// A nonlinear law at strains at which it is linear, where a linear one makes steps faster.
[[nodiscard]] std::string of_law(const Scene& scene);

/// Frames that take longer than a quarter of the steps; stress in frames that no probe and no exact
/// solution asks for. `steps` 0: not known.
template <int D>
[[nodiscard]] std::string of_output(const Scene& scene, const Discretisation<D>& disc,
                                    double steps);

/// Bytes of the fields of a frame.
template <int D>
[[nodiscard]] double frame_bytes(const Scene& scene, const Discretisation<D>& disc);

/// A support above the one its formulation needs. `dt` is the critical step of the scene [s].
template <int D>
[[nodiscard]] std::string of_support(const Scene& scene, const Discretisation<D>& disc, double dt);

}  // namespace tlsph::savings

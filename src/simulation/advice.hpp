#pragma once
/// \file
/// Suggestions for a cheaper scene, one line each with the saving; empty if there is none.

#include <string>

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// A dimension nothing depends on; else a plane of symmetry that is not used. `particles` of the
/// scene as it is.
[[nodiscard]] std::string advise_reduction(const Scene& scene, Index particles);

/// A nonlinear law at strains at which it is linear, where a linear one makes steps faster.
[[nodiscard]] std::string advise_law(const Scene& scene);

/// Frames that take longer than a quarter of the steps; stress in frames that no probe and no exact
/// solution asks for. `steps` 0: not known.
template <int D>
[[nodiscard]] std::string advise_output(const Scene& scene, const Discretisation<D>& body,
                                        double steps);

/// Bytes of the fields of a frame.
template <int D>
[[nodiscard]] double frame_bytes(const Scene& scene, const Discretisation<D>& body);

/// A support above the one its formulation needs. `dt` is the critical step of the scene [s].
template <int D>
[[nodiscard]] std::string advise_support(const Scene& scene, const Discretisation<D>& body,
                                         double dt);

}  // namespace tlsph

#pragma once
/// \file
/// What `plan` and `run` check and report before the first step.

#include "tlsph/model/builder.hpp"
#include "tlsph/simulation/summary.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph {

/// The loads of the scene's boundaries, in their order.
template <int D>
[[nodiscard]] std::vector<LoadedPatch> loaded_patches(const Scene& scene,
                                                      const Discretisation<D>& body);

/// What the results of the scene suffer from though it runs, a sentence each.
template <int D>
[[nodiscard]] std::vector<std::string> warnings(const Scene& scene, const Discretisation<D>& body);

/// What is prescribed at t = 0 and is not where or as fast as the body starts, a sentence each with
/// place, key, amount and the stress that the jump makes.
template <int D>
[[nodiscard]] std::vector<std::string> start_jumps(const Scene& scene,
                                                   const Discretisation<D>& body,
                                                   const InitialState<D>& initial);

/// The step a run of the scene starts with [s]: time.step, or its share of the critical step at the
/// start. InputError for a time.step beyond what is stable, unless the scene allows it, and for
/// more steps than a run could make.
double checked_step(const Scene& scene, const CriticalStep& critical);

}  // namespace tlsph

// A free body spins and deforms for a hundred thousand steps: both momenta stay what they are.
#include <fmt/format.h>

#include "list.hpp"

namespace tlsph {

void satellite(CaseRun& run) {
  constexpr const char* source = "Lee et al. 2019, Fig. 8";
  struct Method {
    const char* formulation;
    double step;  ///< [s], half of the critical one at rest
    double end;   ///< [s], a little over 1e5 steps
  };
  for (const auto& [formulation, step, end] :
       {Method{"stress-point", 0.0148, 1500.0}, Method{"variational", 0.019, 1950.0}}) {
    // Arms that swing as far as these excite each other; below 0.7 of the critical step the central
    // difference does not add to it.
    const CaseScene scene =
        run.scene(formulation, "satellite.toml",
                  {fmt::format("formulation={}", formulation), fmt::format("time.step={}", step),
                   fmt::format("time.end={}", end), "output.frames=0", "output.energy_every=50"});
    const Checks check(run, fmt::format(", {}", formulation));
    if (scene.failed_at) {
      check(source, "simulated time [s]", *scene.failed_at, at_least(end));
      continue;
    }
    const Summary& seen = scene.summary;
    check(source, "steps", static_cast<double>(seen.steps), at_least(1e5));
    check(source, "drift of the linear momentum", seen.linear_momentum_drift, at_most(1e-11));
    check(source, "drift of the angular momentum", seen.angular_momentum_drift, at_most(1e-11));
    check(source, "drift of the energy", seen.energy.drift_relative, at_most(1e-2));
  }
  (void)run.scene("frames", "satellite.toml", {"time.step=0.0148", "time.end=24"});
}

}  // namespace tlsph

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
    if (scene.failed_at) {
      run.at_least(source, fmt::format("simulated time, {} [s]", formulation), end,
                   *scene.failed_at);
      continue;
    }
    const Summary& summary = scene.summary;
    run.at_least(source, fmt::format("steps, {}", formulation), 1e5,
                 static_cast<double>(summary.steps));
    run.at_most(source, fmt::format("drift of the linear momentum, {}", formulation), 1e-11,
                summary.linear_momentum_drift);
    run.at_most(source, fmt::format("drift of the angular momentum, {}", formulation), 1e-11,
                summary.angular_momentum_drift);
    run.at_most(source, fmt::format("drift of the energy, {}", formulation), 1e-2,
                summary.energy.drift_relative);
  }
  (void)run.scene("frames", "satellite.toml", {"time.step=0.0148", "time.end=24"});
}

}  // namespace tlsph

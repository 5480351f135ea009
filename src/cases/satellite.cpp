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
      run.check(source, fmt::format("simulated time, {} [s]", formulation), *scene.failed_at,
                at_least(end));
      continue;
    }
    const Summary& summary = scene.summary;
    const std::string of = std::string(", ") + formulation;
    run.check(source, "steps" + of, static_cast<double>(summary.steps), at_least(1e5));
    run.check(source, "drift of the linear momentum" + of, summary.linear_momentum_drift,
              at_most(1e-11));
    run.check(source, "drift of the angular momentum" + of, summary.angular_momentum_drift,
              at_most(1e-11));
    run.check(source, "drift of the energy" + of, summary.energy.drift_relative, at_most(1e-2));
  }
  (void)run.scene("frames", "satellite.toml", {"time.step=0.0148", "time.end=24"});
}

}  // namespace tlsph

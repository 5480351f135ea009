/// What a scene may ask of the time step.

#include <fmt/format.h>

#include <cmath>

#include "parts.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Limits are computed to a part of a thousand, from the safe side; beyond this share motion grows.
constexpr double largest_share = 1.005;
/// At 10 ns a step and particle a run of a hundred particles would take two weeks.
constexpr double most_steps = 1e12;

}  // namespace

double parts::checked_step(const Scene& scene, const CriticalStep& critical) {
  const TimeScene& time = scene.time;
  if (time.step && *time.step > largest_share * critical.dt && !time.allow_unstable)
    throw InputError(
        time.step_place,
        fmt::format(
            "{:.6g} s exceeds the critical step of this body, {:.6g} s, by {:.2g} %: motion "
            "would grow beyond all bounds; take {:.4g} s or less, leave it out for {:g} of "
            "the critical step, or say time.allow_unstable = true to see what grows",
            *time.step, critical.dt, 100.0 * (*time.step / critical.dt - 1.0), 0.9 * critical.dt,
            time.safety));
  const double dt = time.step.value_or(time.safety * critical.dt);
  const double count = std::ceil(time.end / dt);
  if (!(count <= most_steps))
    throw InputError(
        time.end_place,
        fmt::format("{:g} s take {:.3g} steps of {:.4g} s; a run makes at most {:g}: an end of at "
                    "most {:.3g} s, or steps that are longer",
                    time.end, count, dt, most_steps, most_steps * dt));
  return dt;
}

}  // namespace tlsph

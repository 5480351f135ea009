/// The time step: chosen at the start, followed as the body deforms.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "run_loop.hpp"

namespace tlsph {
namespace {

/// A step this many times smaller than the critical one at the start says that the run will not
/// end.
constexpr double collapse = 1e-4;
/// Limits are computed to a part of a thousand, from the safe side; beyond this share motion grows.
constexpr double largest_share = 1.005;
/// At 10 ns a step and particle a run of a hundred particles would take two weeks.
constexpr double most_steps = 1e12;

/// The steps that a run rehearses before its first one, and how much a material point may deform in
/// each: who follows the deformation reads its speed off the steps before, and there are none.
constexpr int rehearsed_steps = 4;
constexpr double largest_deformation = 0.1;

}  // namespace

double parts::chosen_step(const Scene& scene, const CriticalStep& critical) {
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

template <int D>
void RunLoop<D>::choose_step(Summary& summary) {
  if (scene_.time.step || disc_.linear()) {
    critical_ = critical_step<D>(disc_, state_);
    set_step(parts::chosen_step(scene_, critical_));
  } else {
    follower_.emplace(disc_, state_, scene_.time.safety);
    critical_ = follower_->critical();
    follower_->shorten(rehearsed(parts::chosen_step(scene_, critical_)));
    set_step(follower_->step());
  }
  summary.dt = clock_.dt;
  summary.dt_critical = critical_.dt;
  summary.dt_critical_scaled = critical_.scaled;
  summary.growth_rate = critical_.growth;
}

/// The longest step of at most `dt` with which the initial velocities and the first loads deform no
/// material point by more than a tenth in one of the first steps.
template <int D>
double RunLoop<D>::rehearsed(double dt) const {
  while (dt > collapse * critical_.dt) {
    double most = 0.0;
    try {
      State<D> trial = make_state<D>(disc_, state_.u, state_.v);
      evaluate<D>(disc_, trial);
      start<D>(disc_, trial, dt);
      for (int n = 1; n <= rehearsed_steps && most <= largest_deformation; ++n) {
        const auto before = follower_->strains(trial);
        advance<D>(disc_, trial, dt, static_cast<double>(n) * dt);
        evaluate<D>(disc_, trial);
        most = std::max(most, follower_->deformation(trial, before));
      }
    } catch (const NumericalError&) {
      most = 1.0;
    }
    if (most <= largest_deformation) break;
    dt *= std::clamp(largest_deformation / most, 0.25, 0.95);
  }
  return dt;
}

template <int D>
void RunLoop<D>::set_step(double wanted) {
  if (!(wanted > collapse * critical_.dt)) {
    evaluate_unchecked<D>(disc_, state_);
    report_loss<D>(disc_, state_,
                   fmt::format("the time step collapsed to {:.3e} s, from {:.3e} s at the start: "
                               "the body is being torn or crushed",
                               wanted, scene_.time.safety * critical_.dt));
  }
  clock_ = StepClock::from(state_.time, state_.step, scene_.time.end, wanted);
}

template <int D>
void RunLoop<D>::follow_deformation() {
  if (!follower_ || state_.step == clock_.last()) return;
  if (follower_->follow(state_)) set_step(follower_->step());
}

template void RunLoop<1>::choose_step(Summary&);
template void RunLoop<2>::choose_step(Summary&);
template void RunLoop<1>::follow_deformation();
template void RunLoop<2>::follow_deformation();

}  // namespace tlsph

/// The time step: chosen at the start, followed as the body deforms.

#include <fmt/format.h>

#include <cmath>

#include "run_loop.hpp"

namespace tlsph {
namespace {

/// A step this many times smaller than the last says that the run will not end.
constexpr double collapse = 1e-4;

}  // namespace

template <int D>
void RunLoop<D>::choose_step(Summary& summary) {
  if (scene_.time.step || disc_.linear()) {
    critical_ = critical_step<D>(disc_, state_);
  } else {
    follower_.emplace(disc_, state_, scene_.time.safety);
    critical_ = follower_->critical();
  }
  set_step(scene_.time.step.value_or(scene_.time.safety * critical_.dt));
  summary.dt = clock_.dt;
  summary.dt_critical = critical_.dt;
  summary.dt_critical_scaled = critical_.scaled;
  summary.growth_rate = critical_.growth;
}

template <int D>
void RunLoop<D>::set_step(double wanted) {
  if (!std::isfinite(wanted) || wanted <= 0.0)
    throw NumericalError("the critical time step is not a positive number", state_.time, -1);
  clock_ = Clock::from(state_.time, state_.step, scene_.time.end, wanted);
}

template <int D>
void RunLoop<D>::follow_deformation() {
  if (!follower_ || state_.step == clock_.last()) return;
  const double previous = clock_.dt;
  if (!follower_->follow(state_)) return;
  set_step(follower_->step());
  if (clock_.dt < collapse * previous)
    throw NumericalError(
        fmt::format("the critical time step collapsed to {:.3e} s at t = {:.6e} s: "
                    "the body is being crushed",
                    follower_->critical().dt, state_.time),
        state_.time, -1);
}

template void RunLoop<1>::choose_step(Summary&);
template void RunLoop<2>::choose_step(Summary&);
template void RunLoop<1>::follow_deformation();
template void RunLoop<2>::follow_deformation();

}  // namespace tlsph

/// The time step: chosen at the start, followed as the body deforms.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run_loop.hpp"

namespace tlsph {
namespace {

/// Steps between looks at the deformation, for laws whose stiffness follows it.
constexpr long watch_every = 50;

/// Change of a strain extreme that calls for a new estimate of the step: absolute and relative
/// part.
constexpr double strain_change = 0.03;
constexpr double strain_change_relative = 0.1;

/// A step this many times smaller than the first says that the run will not end.
constexpr double collapse = 1e-4;

template <int D>
StrainExtremes strain_extremes(const TensorField<D>& field) {
  StrainExtremes extremes{};
  for (Index s = 0; s < field.rows(); ++s) {
    const Tensor<D> H = tensor_at<D>(field, s);
    const Tensor<D> E = 0.5 * (H + H.transpose() + H.transpose() * H);
    for (int i = 0; i < D; ++i) {
      extremes[0] = std::min(extremes[0], E(i, i));
      extremes[1] = std::max(extremes[1], E(i, i));
      for (int j = 0; j < i; ++j) extremes[2] = std::max(extremes[2], std::abs(E(i, j)));
    }
  }
  return extremes;
}

}  // namespace

template <int D>
void RunLoop<D>::choose_step(Summary& summary) {
  critical_ = critical_step<D>(disc_, state_);
  longest_ = scene_.time.step.value_or(scene_.time.safety * critical_.dt);
  set_step(longest_);
  summary.dt = clock_.dt;
  summary.dt_critical = critical_.dt;
  summary.dt_critical_scaled = critical_.scaled;
  summary.growth_rate = critical_.growth;
}

/// A body that has softened may stiffen again faster than it is looked at (beyond the limit of
/// hyperbolicity of its law, nothing limits the step one moment and the first one does the next),
/// so no step is longer than the first.
template <int D>
void RunLoop<D>::adapt_step() {
  const auto critical = critical_step_if_any<D>(disc_, state_);
  if (critical) critical_ = *critical;
  const double previous = clock_.dt;
  set_step(critical ? std::min(scene_.time.safety * critical_.dt, longest_) : longest_);
  if (clock_.dt < collapse * previous)
    throw NumericalError(
        fmt::format("the critical time step collapsed to {:.3e} s at t = {:.6e} s: "
                    "the body is being crushed",
                    critical_.dt, state_.time),
        state_.time, -1);
}

template <int D>
void RunLoop<D>::set_step(double wanted) {
  if (!std::isfinite(wanted) || wanted <= 0.0)
    throw NumericalError("the critical time step is not a positive number", state_.time, -1);
  clock_ = Clock::from(state_.time, state_.step, scene_.time.end, wanted);
  estimated_at_ = strain_extremes<D>(state_.H);
}

template <int D>
bool RunLoop<D>::strains_due() const {
  return state_.step % watch_every == 0 && state_.step != clock_.last() && state_.step != 0 &&
         !scene_.time.step && !disc_.linear();
}

template <int D>
void RunLoop<D>::follow_deformation() {
  if (!strains_due()) return;
  const StrainExtremes now = strain_extremes<D>(state_.H);
  bool changed = false;
  for (std::size_t k = 0; k < now.size(); ++k)
    changed = changed || std::abs(now[k] - estimated_at_[k]) >
                             strain_change + strain_change_relative * std::abs(estimated_at_[k]);
  if (changed) adapt_step();
}

template void RunLoop<1>::choose_step(Summary&);
template void RunLoop<2>::choose_step(Summary&);
template bool RunLoop<1>::strains_due() const;
template bool RunLoop<2>::strains_due() const;
template void RunLoop<1>::follow_deformation();
template void RunLoop<2>::follow_deformation();

}  // namespace tlsph

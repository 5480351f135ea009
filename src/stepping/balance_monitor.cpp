#include "tlsph/stepping/balance_monitor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace tlsph {
namespace {

/// Below the critical step the energy ½ v_nᵀ M v_n + U of free motion is 1/(1 − (Δt/Δt_c)²) times
/// what the balance explains, at most; it grows without bound above. This factor, in this many
/// samples in sequence, means growth: the balance knows of a new load a step late.
constexpr double largest_factor = 100.0;
constexpr long most_samples = 8;
/// A state within this factor is kept to return to.
constexpr double kept_factor = 2.0;

/// The node whose acceleration is largest: where the fastest motion is.
template <int D>
Index most_accelerated(const Instant<D>& now) {
  Index most = 0;
  double largest = -1.0;
  for (Index q = 0; q < now.body.nodes(); ++q) {
    double square = 0.0;
    for (int i = 0; i < D; ++i) {
      const double a = now.motion(q * D + i).acceleration;
      square += a * a;
    }
    if (square <= largest) continue;
    largest = square;
    most = q;
    if (!std::isfinite(square)) break;
  }
  return most;
}

template <int D>
NumericalError lost_at(const Instant<D>& now, const std::string& what, const std::string& cure) {
  const Index node = most_accelerated<D>(now);
  const auto X = now.body.particles.X.row(node);
  return {
      fmt::format("{} at t = {:.6e} s, step {}; particle {} at ({:.6g}) m is accelerated most; {}",
                  what, now.time(), now.step(), node, fmt::join(X.begin(), X.end(), ", "), cure),
      now.time(), static_cast<long>(node)};
}

}  // namespace

template <int D>
void BalanceMonitor<D>::add(const Instant<D>& now, const WorkAndImpulse<D>& done, bool counts) {
  last_ = balance<D>(now);
  const double energy = last_.kinetic + last_.elastic;
  if (!std::isfinite(energy + last_.ripple + done.external_work + last_.gravity))
    throw lost_at<D>(now, "the energy is no finite number any more",
                     "velocities, loads or displacements are too large");
  if (now.step() == 0) {
    first_energy_ = energy;
    first_momentum_ = last_.linear_momentum - done.impulse;
    first_angular_ = last_.angular_momentum - done.angular_impulse;
    energy_scale_ = std::max(std::abs(energy), last_.ripple);
  }
  check_growth(now, done);
  if (counts) count(now, done);
}

template <int D>
void BalanceMonitor<D>::count(const Instant<D>& now, const WorkAndImpulse<D>& done) {
  const double energy = last_.kinetic + last_.elastic;
  const double work = done.external_work + last_.gravity;
  const Vector<D> momentum = last_.linear_momentum - done.impulse;
  const double angular = last_.angular_momentum - done.angular_impulse;
  largest_energy_ = std::max(largest_energy_, std::abs(energy));
  drift_ = std::max(drift_,
                    std::abs(energy - first_energy_ - work + done.dissipated + last_.dissipated));
  momentum_scale_ = std::max(momentum_scale_, last_.momentum_scale);
  angular_scale_ = std::max(angular_scale_, last_.angular_scale);
  momentum_drift_ = std::max(momentum_drift_, (momentum - first_momentum_).norm());
  angular_drift_ = std::max(angular_drift_, std::abs(angular - first_angular_));
  if (tolerance_ && drift_ > *tolerance_ * largest_energy_)
    throw lost_at<D>(now,
                     fmt::format("energy left its balance by {:.2g} of the largest energy, more "
                                 "than time.energy_tolerance,",
                                 drift_ / largest_energy_),
                     "a smaller time.safety may help");
}

template <int D>
bool BalanceMonitor<D>::unexplained(const Balance<D>& sample) const {
  return !(sample.kinetic + sample.ripple + sample.elastic <= largest_factor * energy_scale_);
}

/// ½ v_nᵀ M v_n + U against E_0 + W − D.
template <int D>
void BalanceMonitor<D>::check_growth(const Instant<D>& now, const WorkAndImpulse<D>& done) {
  const double work = done.external_work + last_.gravity;
  energy_scale_ =
      std::max({energy_scale_, std::abs(first_energy_ + work - done.dissipated - last_.dissipated),
                std::abs(work)});
  if (!unexplained(last_)) {
    growing_ = 0;
    const double energy = last_.kinetic + last_.ripple + last_.elastic;
    if (energy > kept_factor * energy_scale_ && now.step() > 0) return;
    balanced_.step = now.state.step;
    balanced_.time = now.state.time;
    balanced_.last_dt = now.state.last_dt;
    balanced_.u = now.state.u;
    balanced_.v = now.state.v;
    balanced_.past = now.state.past;
    return;
  }
  if (growing_ == 0) growth_ = lost_at<D>(now, "motion grows beyond all bounds", cure_);
  if (++growing_ > most_samples) throw NumericalError(*growth_);
}

template class BalanceMonitor<1>;
template class BalanceMonitor<2>;

}  // namespace tlsph

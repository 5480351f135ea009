/// The books of a run: its energies and momenta, and whether they say that something grows.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "run_loop.hpp"
#include "stopwatch.hpp"
#include "tlsph/dynamics/hyperbolicity.hpp"

namespace tlsph {
namespace {

/// Somebody looks out of turn where particles have become so many times as fast as ever before.
constexpr double alarming_speed = 8.0;
/// Below the critical step the energy ½ v_nᵀ M v_n + U of free motion is 1/(1 − (Δt/Δt_c)²) times
/// what the books know, at most; it grows without end above. So much is out of all bounds, after so
/// many looks in sequence: books know of a new load a step late.
constexpr double out_of_bounds = 100.0;
constexpr long patience = 8;
/// A state of which this much is not explained is one to go back to.
constexpr double within_bounds = 2.0;

/// The node whose acceleration is largest: where the fastest motion is.
template <int D>
Index most_accelerated(const Discretisation<D>& disc, const State<D>& state, double dt) {
  Index most = 0;
  double largest = -1.0;
  for (Index q = 0; q < disc.nodes(); ++q) {
    double square = 0.0;
    for (int i = 0; i < D; ++i) {
      const double a = motion_of<D>(disc, state, dt, q * D + i).acceleration;
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
NumericalError lost_at(const Discretisation<D>& disc, const State<D>& state, double dt,
                       const std::string& what, const std::string& cure) {
  const Index node = most_accelerated<D>(disc, state, dt);
  std::string where;
  for (int a = 0; a < D; ++a)
    where += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", disc.particles.X(node, a));
  return {fmt::format("{} at t = {:.6e} s, step {}; particle {} at ({}) m is accelerated most; {}",
                      what, state.time, state.step, node, where, cure),
          state.time, static_cast<long>(node)};
}

}  // namespace

template <int D>
bool RunLoop<D>::alarmed() const {
  return growing_ > 0 || !(speed_ <= alarming_speed * known_speed_);
}

/// What is missing in the books or too much in them [J].
template <int D>
double RunLoop<D>::deviation(const Balance<D>& now) const {
  const double work = ledger_.external_work + now.gravity;
  return std::abs(now.kinetic + now.elastic - first_energy_ - work + ledger_.dissipated +
                  now.dissipated);
}

template <int D>
void RunLoop<D>::sample_books() {
  const Stopwatch watch;
  const Balance<D> now = balance<D>(disc_, state_, clock_.dt);
  const double energy = now.kinetic + now.elastic;
  const double work = ledger_.external_work + now.gravity;
  const Vector<D> momentum = now.linear_momentum - ledger_.impulse;
  const double angular = now.angular_momentum - ledger_.angular_impulse;
  if (!std::isfinite(energy + now.ripple + work))
    throw lost_at<D>(disc_, state_, clock_.dt, "the energy is no finite number any more",
                     "velocities, loads or displacements are too large");
  if (state_.step == 0) {
    first_energy_ = energy;
    first_momentum_ = momentum;
    first_angular_ = angular;
    energy_scale_ = std::max(std::abs(energy), now.ripple);
  }
  known_speed_ = std::max(known_speed_, speed_);
  watch_growth(now);
  if (books_due()) {
    largest_energy_ = std::max(largest_energy_, std::abs(energy));
    drift_ = std::max(drift_, deviation(now));
    momentum_scale_ = std::max(momentum_scale_, now.momentum_scale);
    angular_scale_ = std::max(angular_scale_, now.angular_scale);
    momentum_drift_ = std::max(momentum_drift_, (momentum - first_momentum_).norm());
    angular_drift_ = std::max(angular_drift_, std::abs(angular - first_angular_));
    if (output_) {
      std::array<double, 6 + D> row{now.kinetic, now.elastic, work,
                                    ledger_.dissipated + now.dissipated};
      for (std::size_t i = 0; i < D; ++i) row[4 + i] = now.linear_momentum[static_cast<Index>(i)];
      row[4 + D] = now.angular_momentum;
      row[5 + D] = clock_.dt;
      output_->write_series(state_.time, row);
    }
    const double tolerance =
        scene_.time.energy_tolerance.value_or(std::numeric_limits<double>::infinity());
    if (drift_ > tolerance * largest_energy_)
      throw lost_at<D>(disc_, state_, clock_.dt,
                       fmt::format("energy left its balance by {:.2g} of the largest energy, more "
                                   "than time.energy_tolerance,",
                                   drift_ / largest_energy_),
                       "a smaller time.safety may help");
  }
  output_seconds_ += watch.seconds();
}

/// ½ v_nᵀ M v_n + U against E_0 + W − D. NumericalError where it has been out of all bounds for a
/// while, of the time when that began.
template <int D>
void RunLoop<D>::watch_growth(const Balance<D>& now) {
  const double work = ledger_.external_work + now.gravity;
  energy_scale_ =
      std::max({energy_scale_, std::abs(first_energy_ + work - ledger_.dissipated - now.dissipated),
                std::abs(work)});
  const double energy = now.kinetic + now.ripple + now.elastic;
  if (!(energy > out_of_bounds * energy_scale_)) {
    growing_ = 0;
    if (energy <= within_bounds * energy_scale_ || state_.step == 0)
      balanced_ = {state_.step, state_.time, state_.last_dt, state_.u, state_.v, state_.past};
    return;
  }
  if (growing_ == 0)
    growth_ = lost_at<D>(
        disc_, state_, clock_.dt, "motion grows beyond all bounds",
        scene_.time.step
            ? fmt::format("time.step, {:.4g} s, is above the critical step of the body as it is "
                          "now: take a smaller one, or time.safety",
                          *scene_.time.step)
            : std::string("a smaller time.safety, a stabiliser or a formulation whose divergence "
                          "is the adjoint of its gradient may help"));
  if (++growing_ > patience) throw NumericalError(*growth_);
}

template <int D>
void RunLoop<D>::watch_hyperbolicity() {
  if (hyperbolicity_lost_ || disc_.linear()) return;
  const Stopwatch watch;
  const auto worst = most_unstable_point<D>(disc_, state_);
  output_seconds_ += watch.seconds();
  if (!worst) return;
  const auto X = disc_.points.X.row(worst->point);
  hyperbolicity_lost_ = {state_.time,
                         worst->point,
                         {X.begin(), X.end()},
                         {worst->stretches.begin(), worst->stretches.end()},
                         worst->acoustic_eigenvalue};
}

/// One step back, u_n = u_{n−1} + Δt v_{n−½}, or to the last state within its balance where that
/// one has grown already. Frames of the lost state itself do not exist, for evaluate throws first.
template <int D>
void RunLoop<D>::keep_last_good_state() {
  if (!output_ || state_.step == 0) return;
  try {
    if (growing_ == 0) {
      state_.u -= state_.last_dt * state_.v;
      state_.time -= state_.last_dt;
      --state_.step;
      evaluate<D>(disc_, state_);
      const Balance<D> now = balance<D>(disc_, state_, clock_.dt);
      const double energy = now.kinetic + now.ripple + now.elastic;
      if (!(energy <= out_of_bounds * energy_scale_)) growing_ = 1;
    }
    if (growing_ > 0) {
      if (balanced_.u.size() == 0) return;
      state_.step = balanced_.step;
      state_.time = balanced_.time;
      state_.last_dt = balanced_.last_dt;
      state_.u = balanced_.u;
      state_.v = balanced_.v;
      state_.past = balanced_.past;
      evaluate<D>(disc_, state_);
    }
    if (!output_->has_frame(state_.time, 0.5 * state_.last_dt))
      output_->write_frame(disc_, state_, clock_.dt);
  } catch (const NumericalError&) {
    // Lost for more than a step without notice; the frames before stand.
  }
}

template <int D>
void RunLoop<D>::finish(Summary& summary) {
  const Balance<D> now = balance<D>(disc_, state_, clock_.dt);
  if (output_) {
    const Stopwatch watch;
    output_->flush();
    summary.wall_output += watch.seconds();
  }
  summary.hyperbolicity_lost = hyperbolicity_lost_;
  summary.steps = state_.step;
  summary.end_time = state_.time;
  summary.energy = {now.kinetic, now.elastic, ledger_.external_work + now.gravity,
                    ledger_.dissipated + now.dissipated,
                    largest_energy_ > 0.0 ? drift_ / largest_energy_ : 0.0};
  summary.linear_momentum_drift = momentum_scale_ > 0.0 ? momentum_drift_ / momentum_scale_ : 0.0;
  summary.angular_momentum_drift = angular_scale_ > 0.0 ? angular_drift_ / angular_scale_ : 0.0;
}

template void RunLoop<1>::sample_books();
template bool RunLoop<1>::alarmed() const;
template double RunLoop<1>::deviation(const Balance<1>&) const;
template void RunLoop<1>::watch_growth(const Balance<1>&);
template void RunLoop<1>::watch_hyperbolicity();
template void RunLoop<1>::keep_last_good_state();
template void RunLoop<1>::finish(Summary&);
template void RunLoop<2>::sample_books();
template bool RunLoop<2>::alarmed() const;
template double RunLoop<2>::deviation(const Balance<2>&) const;
template void RunLoop<2>::watch_growth(const Balance<2>&);
template void RunLoop<2>::watch_hyperbolicity();
template void RunLoop<2>::keep_last_good_state();
template void RunLoop<2>::finish(Summary&);

}  // namespace tlsph

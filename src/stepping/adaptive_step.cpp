#include "tlsph/stepping/adaptive_step.hpp"

#include <algorithm>
#include <cmath>

#include "tlsph/core/stopwatch.hpp"

namespace tlsph {
namespace {

/// A check costs a pass over H. Where nothing moves there is one in so many steps.
constexpr long longest_interval = 32;
/// What an estimate costs, in steps, and what may be spent on estimates: so much at any time and
/// this share of the steps.
constexpr double cost_of_estimate = 50.0;
constexpr double initial_credit = 500.0;
constexpr double credit_per_step = 0.25;
/// The first one is as good as it can be; those of a state that goes on to change need not be.
constexpr double tolerance_of_estimate = 1e-2;
/// No material point deforms by more than this in a step: tangents that are safe at its start must
/// not be overtaken before its end.
constexpr double largest_deformation_per_step = 0.1;
/// Tangents change by about five times the relative deformation, the step by half of that; this is
/// the share of 1 − safety that one deformation between bounds may take.
constexpr double deformation_share = 0.2;
constexpr double smallest_deformation = 1e-3;
/// Every change of the step costs energy that equal steps keep: a step stays while it takes no more
/// than this share of 1 − safety, and falls by a notch at least.
constexpr double kept_share = 0.2;
constexpr double notch = 0.97;
/// A run that asks for short steps does so for its accuracy; up to this share of the limit they are
/// safe all the same.
constexpr double always_kept = 0.7;
/// Particles this many times as fast as at the last check mean an impact.
constexpr double impact_speed = 2.0;
/// A body whose particles have moved by so little cannot have used up more of that: no check.
constexpr double negligible_share = 0.1;

/// The largest Σ_q |w^a_sq| over the material points and directions.
template <int D>
double largest_row_sum(const VectorOperator<D>& gradient) {
  double largest = 0.0;
  for (Index s = 0; s < gradient.rows(); ++s) {
    double sum = 0.0;
    for (Index k = gradient.pattern().start[static_cast<std::size_t>(s)];
         k < gradient.pattern().start[static_cast<std::size_t>(s) + 1]; ++k)
      for (int a = 0; a < D; ++a) sum += std::abs(gradient.weight(k, a));
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace

template <int D>
AdaptiveStep<D>::AdaptiveStep(const Discretisation<D>& body, const State<D>& state, double safety)
    : body_(body),
      safety_(std::max(safety, notch * always_kept)),
      kept_(std::max(safety + kept_share * (1.0 - safety), always_kept)),
      deformation_(std::max(smallest_deformation, deformation_share * (1.0 - safety))),
      critical_(critical_step<D>(body, state)),
      initial_limit_(critical_.dt),
      limit_(initial_limit_),
      step_(safety * initial_limit_),
      steady_(step_),
      monitor_(std::make_unique<StrainMonitor<D>>(body)),
      H_estimate_(monitor_->strains(state)),
      H_bound_(H_estimate_),
      memory_estimate_(state.memory),
      row_sum_(body.ghosts ? 0.0 : largest_row_sum<D>(body.gradient)),
      last_check_(state.step),
      next_check_(state.step + 1),
      estimates_(1) {}

template <int D>
AdaptiveStep<D>::~AdaptiveStep() = default;

template <int D>
void AdaptiveStep<D>::use_operators_of(const Sweep<D>& sweep) {
  monitor_->use_operators_of(sweep);
  sweep_ = &sweep;
}

/// s with (s Δt)² (ω² + added) = 4 where Δt = 2/ω; with a viscosity, whose share of Δt²K + 2ΔtC
/// falls with s only, 4s + (s Δt)² added = 4.
template <int D>
double AdaptiveStep<D>::share_of_estimate(double added) const {
  const double dt = std::min(critical_.dt, initial_limit_);
  const double c = dt * dt * added;
  if (body_.viscosity.nonZeros() == 0) return 1.0 / std::sqrt(1.0 + 0.25 * c);
  return 2.0 / (1.0 + std::sqrt(1.0 + c));
}

template <int D>
double AdaptiveStep<D>::bound(const State<D>& state) const {
  const double gamma = gamma_ > 0.0 ? gamma_ : unit_stiffness<D>(body_, sweep_);
  StrainField strains = H_bound_;
  const auto change = monitor_->change(state, H_estimate_, memory_estimate_, strains);
  return std::min(critical_.dt, initial_limit_) * share_of_estimate(gamma * change.stiffening);
}

/// Beyond the limit of hyperbolicity of its law, nothing limits the step of a body one moment and
/// the first estimate does the next.
template <int D>
void AdaptiveStep<D>::estimate(State<D>& state) {
  ++estimates_;
  if (!monitor_->reads_strains()) body_.gradient.gradient(state.u, state.H);
  const auto critical = critical_step_if_any<D>(body_, state, tolerance_of_estimate, sweep_);
  if (critical) critical_ = *critical;
  if (!critical || !(critical_.dt < initial_limit_)) critical_.dt = initial_limit_;
  monitor_->store(state, H_estimate_);
  memory_estimate_ = state.memory;
  limit_ = critical_.dt;
}

template <int D>
void AdaptiveStep<D>::take_bound(State<D>& state) {
  ++bounds_;
  if (gamma_ == 0.0)
    gamma_ = unit_stiffness<D>(body_, sweep_);  // not needed by a body that hardly deforms
  const auto change = monitor_->change(state, H_estimate_, memory_estimate_, H_bound_);
  limit_ = std::min(critical_.dt, initial_limit_) * share_of_estimate(gamma_ * change.stiffening);
  change_ = 0.0;
  if (steady_ <= kept_ * limit_) return;
  const double credit = initial_credit + credit_per_step * static_cast<double>(state.step);
  if (cost_of_estimate * static_cast<double>(estimates_) <= credit) estimate(state);
  if (steady_ > kept_ * limit_) steady_ = std::min(safety_ * limit_, notch * steady_);
}

/// Short steps while a point deforms fast, and the steady one again when that would let no point
/// deform by half as much as is allowed. `most` is a bound of the deformation a step, `rate` what
/// has been seen of it.
template <int D>
void AdaptiveStep<D>::limit_deformation(const State<D>& state, double rate, double most) {
  const double allowed = state.last_dt * largest_deformation_per_step;
  if (step_ * rate > allowed)
    step_ = std::min(allowed / rate, notch * step_);
  else if (2.0 * steady_ * most <= allowed)
    step_ = steady_;
  step_ = std::min(step_, steady_);
}

/// |ΔH| ≤ Σ_q |w_sq| max |Δu|, over all directions.
template <int D>
bool AdaptiveStep<D>::due(const State<D>& state) const {
  if (!moves_known_) return state.step >= next_check_;
  const bool impact = last_move_ > impact_speed * move_at_check_;
  return (impact || state.step >= next_check_) &&
         row_sum_ * moved_ >= negligible_share * deformation_;
}

template <int D>
bool AdaptiveStep<D>::update(State<D>& state) {
  if (!due(state)) return false;
  const Stopwatch watch;
  ++checks_;
  moved_ = 0.0;
  move_at_check_ = last_move_;
  const double change = monitor_->deformation(state, H_bound_);
  const long quiet = std::max(1L, state.step - last_check_);
  const double rate = std::max(change - change_, 0.0) / static_cast<double>(quiet);
  const double most = (change + change_) / static_cast<double>(quiet);
  change_ = change;
  const double before = step_;
  if (change >= 0.5 * deformation_) take_bound(state);
  limit_deformation(state, rate, most);
  // Until half the allowance is used up, and not much longer than it has been quiet.
  const double wanted = rate > 0.0 ? 0.5 * deformation_ / rate : 1e9;
  const long interval = std::clamp(static_cast<long>(std::min(wanted, 1e6)), 1L,
                                   std::min(longest_interval, 2 * quiet));
  last_check_ = state.step;
  next_check_ = state.step + interval;
  seconds_ += watch.seconds();
  return step_ != before;
}

template class AdaptiveStep<1>;
template class AdaptiveStep<2>;

}  // namespace tlsph

#include "tlsph/stepping/stepper.hpp"

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/error.hpp"
#include "tlsph/core/parallel.hpp"

namespace tlsph {
namespace {

/// A step this many times smaller than the critical one at the start says that the run will not
/// end.
constexpr double collapse = 1e-4;
/// The steps that are tried out before the first one, and how much a material point may deform in
/// each.
constexpr int rehearsed_steps = 4;
constexpr double largest_deformation = 0.1;
/// A sample of the balance is taken out of turn where particles have become so many times as fast
/// as ever before.
constexpr double alarming_speed = 8.0;

std::string cure_of_growth(const std::optional<double>& step) {
  if (!step)
    return "a smaller time.safety, a stabiliser or a formulation whose divergence is the adjoint "
           "of its gradient may help";
  return fmt::format(
      "time.step, {:.4g} s, is above the critical step of the body as it is now: take a smaller "
      "one, or time.safety",
      *step);
}

}  // namespace

template <int D>
Stepper<D>::Stepper(const Discretisation<D>& body, VectorField<D> u, VectorField<D> v,
                    StepperOptions<D> options)
    : body_(body),
      options_(std::move(options)),
      state_(make_state<D>(body, std::move(u), std::move(v))),
      forces_(body),
      monitor_(options_.energy_tolerance, cure_of_growth(options_.step)) {
  compute_forces(state_);
  if (options_.step) return;
  if (!options_.adaptive || body_.linear()) {
    critical_ = critical_step<D>(body_, state_);
  } else {
    adaptive_.emplace(body_, state_, options_.safety);
    critical_ = adaptive_->critical();
  }
}

template <int D>
const CriticalStep& Stepper<D>::critical() {
  if (!critical_) critical_ = critical_step<D>(body_, state_);
  return *critical_;
}

template <int D>
void Stepper<D>::compute_forces(State<D>& state) const {
  if (options_.evaluate)
    options_.evaluate(body_, state);
  else
    tlsph::evaluate<D>(body_, state);
}

/// The longest step of at most `dt` with which the initial velocities and the first loads deform no
/// material point by more than a tenth in one of the first steps.
template <int D>
double Stepper<D>::rehearsed(double dt) const {
  StrainMonitor<D> monitor(body_);
  while (dt > collapse * critical_->dt) {
    double most = 0.0;
    try {
      State<D> trial = make_state<D>(body_, state_.u, state_.v);
      compute_forces(trial);
      tlsph::start<D>(body_, trial, dt);
      for (int n = 1; n <= rehearsed_steps && most <= largest_deformation; ++n) {
        const auto before = monitor.strains(trial);
        advance<D>(body_, trial, dt, static_cast<double>(n) * dt);
        compute_forces(trial);
        most = std::max(most, monitor.deformation(trial, before));
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
void Stepper<D>::start(bool resumed) {
  double dt = options_.step ? *options_.step : options_.safety * critical_->dt;
  if (adaptive_ && options_.rehearse) adaptive_->shorten(dt = rehearsed(dt));
  set_step(adaptive_ ? adaptive_->step() : dt);
  plan_sweep();
  if (resumed) return;
  tlsph::start<D>(body_, state_, clock_.dt);
  speed_ = state_.v.cwiseAbs().maxCoeff();
}

template <int D>
void Stepper<D>::plan_sweep() {
  const int available = options_.threads > 0 ? options_.threads : omp_get_max_threads();
  threads_ = worth_threads(body_.nodes()) ? available : 1;
  if (!options_.sweep || options_.evaluate || !Sweep<D>::possible(body_)) {
    if (worth_threads(body_.points.size())) threads_ = available;
    return;
  }
  SweepOptions options;
  options.threads = threads_;
  options.single_weights = options_.single_weights;
  sweep_.emplace(body_, options);
  if (adaptive_) adaptive_->use_operators_of(*sweep_);
}

template <int D>
void Stepper<D>::set_step(double wanted) {
  if (critical_ && !(wanted > collapse * critical_->dt)) {
    evaluate_unchecked<D>(body_, state_);
    report_loss<D>(body_, state_,
                   fmt::format("the time step collapsed to {:.3e} s, from {:.3e} s at the start: "
                               "the body is being torn or crushed",
                               wanted, options_.safety * critical_->dt));
  }
  clock_ = StepClock::from(state_.time, state_.step, options_.end, wanted);
}

template <int D>
void Stepper<D>::adapt() {
  if (adapted_) return;
  adapted_ = true;
  if (adaptive_ && !done() && adaptive_->update(state_)) set_step(adaptive_->step());
}

template <int D>
void Stepper<D>::evaluate() {
  if (evaluated_) return;
  if (clock_.count == 0) start();
  if (sweep_) {
    const Stopwatch watch;
    sweep_->evaluate(state_);
    observing_ += watch.seconds();
  } else {
    speed_ = state_.v.cwiseAbs().maxCoeff();
    compute_forces(state_);
  }
  evaluated_ = true;
  adapt();
  if (options_.balance_every == 0) return;
  forces_.gather(instant());
  if (state_.step > 0) work_.add_before(forces_, instant());
  before_added_ = true;
}

template <int D>
void Stepper<D>::evaluate(const PartialEvaluation<D>& some) {
  if (evaluated_) return;
  if (clock_.count == 0) start();
  const Stopwatch watch;
  some.evaluate(body_, state_);
  observing_ += watch.seconds();
}

template <int D>
bool Stepper<D>::balance_due() const {
  return options_.balance_every > 0 && (state_.step % options_.balance_every == 0 || done());
}

template <int D>
bool Stepper<D>::alarmed() const {
  return monitor_.growing() || !(speed_ <= alarming_speed * known_speed_);
}

template <int D>
void Stepper<D>::prepare(bool whole) {
  if (clock_.count == 0) start();
  if (whole || !sweep_ || (options_.balance_every > 0 && (balance_due() || alarmed()))) evaluate();
  adapt();
}

template <int D>
bool Stepper<D>::sample_balance(bool out_of_turn) {
  sampled_ = true;
  const bool due = balance_due();
  if (options_.balance_every == 0 || !(due || out_of_turn || alarmed())) return false;
  const Stopwatch watch;
  known_speed_ = std::max(known_speed_, speed_);
  monitor_.add(instant(), work_, due);
  if (due && !hyperbolicity_lost_ && !body_.linear())
    hyperbolicity_lost_ = most_unstable_point<D>(body_, state_);
  observing_ += watch.seconds();
  return due;
}

template <int D>
void Stepper<D>::step() {
  prepare();
  if (!sampled_) sample_balance();
  const double next = clock_.time(state_.step + 1);
  if (!sweep_) {
    if (options_.balance_every > 0) work_.add_after(forces_, instant());
    advance<D>(body_, state_, clock_.dt, next);
  } else {
    const Steps steps{state_.last_dt, clock_.dt, before_added_ || state_.step == 0};
    sweep_->step(state_, clock_.dt, next, forces_);
    speed_ = forces_.largest_speed;
    if (adaptive_) adaptive_->moved_by(clock_.dt * speed_);
    if (options_.balance_every > 0) work_.add_step(body_, forces_, state_, steps);
  }
  evaluated_ = adapted_ = sampled_ = before_added_ = false;
}

template <int D>
void Stepper<D>::run(const std::function<void(const Instant<D>&)>& observe, long every) {
  while (true) {
    prepare();
    sample_balance();
    if (done() || state_.step % every == 0) {
      evaluate();
      observe(instant());
    }
    if (done()) return;
    step();
  }
}

/// One step back, u_n = u_{n−1} + Δt v_{n−½}, or to the last state within its balance where that
/// one has grown already.
template <int D>
bool Stepper<D>::restore_last_good() {
  if (state_.step == 0) return false;
  if (!monitor_.growing()) {
    state_.u -= state_.last_dt * state_.v;
    state_.time -= state_.last_dt;
    --state_.step;
    compute_forces(state_);
    if (!monitor_.unexplained(tlsph::balance<D>(instant()))) return true;
  }
  const State<D>& balanced = monitor_.balanced();
  if (balanced.u.size() == 0) return false;
  state_.step = balanced.step;
  state_.time = balanced.time;
  state_.last_dt = balanced.last_dt;
  state_.u = balanced.u;
  state_.v = balanced.v;
  state_.past = balanced.past;
  compute_forces(state_);
  return true;
}

template class Stepper<1>;
template class Stepper<2>;

}  // namespace tlsph

#pragma once
/// \file
/// The steps of a body, from its initial state on: one door to the central difference, in one pass
/// (sweep/sweep.hpp) where the discretisation allows it, operator by operator (dynamics/state.hpp)
/// otherwise. A Stepper chooses the step and follows the deformation with it, keeps the balance of
/// energy and momenta, and watches for motion that grows without bound and for materials that lose
/// hyperbolicity.
///
///     Stepper<2> stepper(body, u, v, {.end = 1e-3});
///     stepper.run([&](const Instant<2>& now) { … }, 10);  // every tenth step and the last

#include <functional>
#include <limits>
#include <optional>

#include "tlsph/core/stopwatch.hpp"
#include "tlsph/dynamics/hyperbolicity.hpp"
#include "tlsph/dynamics/partial_evaluation.hpp"
#include "tlsph/stepping/adaptive_step.hpp"
#include "tlsph/stepping/balance_monitor.hpp"
#include "tlsph/stepping/step_clock.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

template <int D>
struct StepperOptions {
  double end = std::numeric_limits<double>::infinity();  ///< that the last step lands on [s]
  double safety = 0.9;                                   ///< share of the critical step
  std::optional<double> step =
      {};                ///< equal steps of this length instead [s], whatever is critical
  bool adaptive = true;  ///< steps follow the deformation where a law is not linear
  /// The first steps are tried out and shortened where a material point deforms by more than a
  /// tenth in one of them: there are none before to read that off.
  bool rehearse = true;
  bool sweep = true;            ///< in one pass where possible
  int threads = 0;              ///< of a pass; 0: those of OpenMP, one for a small body
  bool single_weights = false;  ///< see SweepOptions
  /// Steps between samples of the balance; 0: none, and nothing is watched.
  long balance_every = 50;
  std::optional<double> energy_tolerance =
      {};  ///< largest drift of the energy, over the largest energy
  /// Leaves H, P and f in the state instead of `tlsph::evaluate`: other forces than those of the
  /// discretisation. Their work is not in the balance; the steps go operator by operator.
  std::function<void(const Discretisation<D>&, State<D>&)> evaluate = {};
};

template <int D>
class Stepper {
 public:
  /// At t = 0, u and v(0) N×d, the forces evaluated and the critical step known unless the options
  /// set the step. The discretisation must outlive this. NumericalError as `evaluate`, or if
  /// nothing limits the step.
  Stepper(const Discretisation<D>& discretisation, VectorField<D> u, VectorField<D> v,
          StepperOptions<D> options = {});

  /// Steps to the end; calls `observe` with every `every`-th step and the last, evaluated.
  void run(const std::function<void(const Instant<D>&)>& observe, long every = 1);

  /// One step. NumericalError as `evaluate`, the state at t_n restored to rounding.
  void step();
  /// Whether the end is reached.
  [[nodiscard]] bool done() const { return clock_.count > 0 && state_.step == clock_.last(); }

  /// The state and what can be seen of it; H, P and f are those of t_n after `evaluate`.
  [[nodiscard]] const State<D>& state() const { return state_; }
  [[nodiscard]] Instant<D> instant() const { return {body_, state_, clock_.dt}; }
  /// H, P and f of the whole state at t_n.
  void evaluate();
  /// Of some nodes and points only; `Sweep::possible`.
  void evaluate(const PartialEvaluation<D>& some);
  [[nodiscard]] bool evaluated() const { return evaluated_; }

  // What `run` and `step` do by themselves, for loops with observers of their own.

  /// Chooses the step and plans the passes; `run` and `step` do so before the first step.
  /// `resumed`: the state goes on after `visit`, instead of starting with a half step back.
  void start(bool resumed = false);
  /// Adapts the step, once a step; evaluates where `whole` or a sample of the balance is due.
  void prepare(bool whole = false);
  /// Takes that sample, or one out of turn. True if it is one of those every `balance_every` steps.
  bool sample_balance(bool out_of_turn = false);
  /// Whether this step's sample is one of those every `balance_every` steps, or the last.
  [[nodiscard]] bool balance_due() const;
  void set_balance_every(long steps) { options_.balance_every = steps; }
  /// Back to the last state within its balance, evaluated. False if there is none.
  [[nodiscard]] bool restore_last_good();

  [[nodiscard]] double dt() const { return clock_.dt; }       ///< the coming step [s]
  [[nodiscard]] long steps() const { return clock_.last(); }  ///< in all, as far as is known
  [[nodiscard]] const CriticalStep& critical();
  /// nullptr where the step stays as it is.
  [[nodiscard]] const AdaptiveStep<D>* adaptive() const {
    return adaptive_ ? &*adaptive_ : nullptr;
  }
  /// nullptr where steps go operator by operator.
  [[nodiscard]] const Sweep<D>* sweep() const { return sweep_ ? &*sweep_ : nullptr; }
  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] const WorkAndImpulse<D>& work() const { return work_; }
  [[nodiscard]] const BalanceMonitor<D>& balance() const { return monitor_; }
  [[nodiscard]] const std::optional<HyperbolicityLoss>& hyperbolicity_lost() const {
    return hyperbolicity_lost_;
  }
  /// Wall time of what observers and samples asked for beside the steps [s].
  [[nodiscard]] double observing_seconds() const { return observing_; }

  /// Calls `visit(name, value)` for all that a checkpoint needs to go on bit for bit.
  template <class Visit>
  void visit(const Visit& visit) {
    const auto below = [&](const std::string& group) {
      return [&visit, group](const std::string& name, auto& value) { visit(group + name, value); };
    };
    visit("u", state_.u);
    visit("v", state_.v);
    if (state_.past.size() > 0) visit("past", state_.past);
    visit("step", state_.step);
    visit("time", state_.time);
    visit("last_dt", state_.last_dt);
    clock_.visit(below("clock."));
    (void)critical();
    visit("critical.dt", critical_->dt);
    visit("critical.scaled", critical_->scaled);
    work_.visit(below("work."));
    visit("balance_every", options_.balance_every);
    monitor_.visit(below("balance."));
    visit("speed", speed_);
    visit("known_speed", known_speed_);
    visit("hyperbolicity_lost", hyperbolicity_lost_);
    if (adaptive_) adaptive_->visit(below("adaptive."));
  }

 private:
  void compute_forces(State<D>& state) const;
  [[nodiscard]] double rehearsed(double dt) const;
  void plan_sweep();
  void set_step(double wanted);
  void adapt();
  [[nodiscard]] bool alarmed() const;

  const Discretisation<D>& body_;
  StepperOptions<D> options_;
  State<D> state_;
  StepClock clock_{.count = 0};
  std::optional<CriticalStep> critical_;
  std::optional<AdaptiveStep<D>> adaptive_;
  int threads_ = 1;
  std::optional<Sweep<D>> sweep_;
  BoundaryForces<D> forces_;
  WorkAndImpulse<D> work_;
  BalanceMonitor<D> monitor_;
  std::optional<HyperbolicityLoss> hyperbolicity_lost_;
  double speed_ = 0.0, known_speed_ = 0.0;  ///< largest now, and in the samples [m/s]
  bool evaluated_ = false;                  ///< H, P and f are those of the state, everywhere
  bool adapted_ = false;                    ///< the step is chosen
  bool sampled_ = false;                    ///< the balance, if it was due
  bool before_added_ = false;               ///< the forces' half of the step before is in `work_`
  double observing_ = 0.0;
};

}  // namespace tlsph

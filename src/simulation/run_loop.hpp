#pragma once
/// \file
/// The time loop of a run, from the initial state or a checkpoint to the end. Not for other rooms.

#include <omp.h>

#include <optional>
#include <string>

#include "clock.hpp"
#include "run_output.hpp"
#include "tlsph/dynamics/excerpt.hpp"
#include "tlsph/dynamics/step_follower.hpp"
#include "tlsph/dynamics/sweep.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {

/// What a state is recomputed from.
template <int D>
struct Snapshot {
  long step = 0;
  double time = 0.0, last_dt = 0.0;
  VectorField<D> u, v;
  MemoryField past;
};

template <int D>
class RunLoop {
 public:
  RunLoop(const Scene& scene, const RunOptions& options, const Discretisation<D>& discretisation);

  /// Steps to the end, or to the step after a stop was asked for. Fills what the loop knows of
  /// `summary`. NumericalError leaves the last good state as a frame.
  void run(Summary& summary);

 private:
  void plan_sweep(Summary& summary);
  /// Calls `visit(name, value)` for all that a checkpoint holds of the run, its fields included.
  template <class Visit>
  void visit(const Visit& visit);
  void resume_from(const Checkpoint& checkpoint);
  void save_checkpoint();
  void choose_step(Summary& summary);
  void set_step(double wanted);
  [[nodiscard]] double rehearsed(double dt) const;
  void follow_deformation();
  void evaluate_for_observers();
  [[nodiscard]] bool books_due() const;
  [[nodiscard]] bool frame_due() const;
  [[nodiscard]] bool probes_due() const;
  void observe();
  void sample_books();
  [[nodiscard]] bool alarmed() const;
  void watch_growth(const Balance<D>& now);
  [[nodiscard]] double deviation(const Balance<D>& now) const;
  void watch_hyperbolicity();
  void step();
  void keep_last_good_state();
  [[nodiscard]] bool checkpoint_due() const;
  void report_progress();
  void finish(Summary& summary);

  const Scene& scene_;
  const RunOptions& options_;
  const Discretisation<D>& disc_;
  const int threads_ = omp_get_max_threads();  ///< of the set-up; a small body steps on one
  ExactSolution<D> exact_;
  Probes<D> probes_;
  std::optional<Sweep<D>> sweep_;  ///< where the discretisation allows it
  std::optional<BoundaryForces<D>> forces_;
  std::optional<Excerpt<D>> excerpt_;  ///< what probes look at
  State<D> state_;
  StepClock clock_;
  Ledger<D> ledger_;
  CriticalStep critical_;
  std::optional<StepFollower<D>> follower_;  ///< of bodies whose stiffness changes
  std::optional<RunOutput<D>> output_;

  // Books of the whole run, kept by checkpoints.
  double first_energy_ = 0.0, largest_energy_ = 0.0, drift_ = 0.0;
  Vector<D> first_momentum_ = Vector<D>::Zero();
  double first_angular_ = 0.0, momentum_scale_ = 0.0, angular_scale_ = 0.0;
  double momentum_drift_ = 0.0, angular_drift_ = 0.0;
  double energy_scale_ = 0.0;               ///< largest energy that the books can explain [J]
  double speed_ = 0.0, known_speed_ = 0.0;  ///< largest now, and when somebody looked [m/s]
  std::optional<HyperbolicityLoss> hyperbolicity_lost_;
  long books_every_ = 1;
  long next_frame_ = 0;
  long growing_ = 0;  ///< looks in sequence that found an energy out of all bounds
  std::optional<NumericalError> growth_;  ///< where that began
  Snapshot<D> balanced_;                  ///< the last state within its balance
  bool evaluated_ = false;                ///< H, P and f are those of the state, everywhere

  double output_seconds_ = 0.0, last_progress_ = 0.0, last_checkpoint_ = 0.0;
};

}  // namespace tlsph

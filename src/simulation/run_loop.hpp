#pragma once
/// \file
/// A run of a scene, from the initial state or a checkpoint to the end: its steps, and what is
/// written of them.

#include <omp.h>

#include <optional>

#include "run_output.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/stepping/stepper.hpp"

namespace tlsph {

template <int D>
class RunLoop {
 public:
  /// All arguments outlive the loop, which fills what it knows of `summary`.
  RunLoop(const Scene& scene, const RunOptions& options, const Discretisation<D>& body,
          Summary& summary);

  /// From the initial state, or that of a checkpoint, to the end, or to the step after a stop was
  /// asked for. NumericalError leaves the last good state as a frame.
  void run();

 private:
  void start();
  void open_files();
  /// Calls `visit(name, value)` for all that a checkpoint holds of the run, its fields included.
  template <class Visit>
  void visit(const Visit& visit);
  void resume_from(const Checkpoint& checkpoint);
  void save_checkpoint();
  [[nodiscard]] bool frame_due() const;
  [[nodiscard]] bool probes_due() const;
  void observe();
  void sample_probes();
  void keep_probes();
  void write_series();
  void keep_last_good_state();
  [[nodiscard]] bool checkpoint_due() const;
  void report_progress();
  void finish();
  void measure_errors();
  [[nodiscard]] double frame_time() const;
  [[nodiscard]] const State<D>& state() const { return stepper_->state(); }

  const Scene& scene_;
  const RunOptions& options_;
  const Discretisation<D>& body_;
  Summary& summary_;
  const int threads_ = omp_get_max_threads();  ///< of the set-up; a small body steps on one
  ExactSolution<D> exact_;
  Probes<D> probes_;
  std::optional<PartialEvaluation<D>> probed_;  ///< what probes read, where a sweep steps
  std::optional<Stepper<D>> stepper_;
  std::optional<RunOutput<D>> output_;
  ProbeHistories recorded_;                    ///< the columns of the probes, without rows
  std::vector<double> probe_row_, exact_row_;  ///< time first
  bool row_waits_ = false;
  long next_frame_ = 0;
  double output_seconds_ = 0.0, last_progress_ = 0.0, last_checkpoint_ = 0.0;
};

}  // namespace tlsph

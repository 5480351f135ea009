#pragma once
/// \file
/// One worker's part of a sweep: its plan, its windows, and the loop over its tasks.

#include <array>
#include <vector>

#include "loops.hpp"
#include "plan.hpp"
#include "region_laws.hpp"
#include "tlsph/dynamics/balance.hpp"
#include "tlsph/dynamics/state.hpp"

namespace tlsph::sweep {

/// What all workers share, constant in time.
template <int D>
struct SweepBody {
  const Discretisation<D>* disc = nullptr;
  const Loops<D>* loops = nullptr;
  RowWeights gradient, divergence, rows;
  BlockWeights blocks;      ///< where `has_blocks`, all that forces are made of
  bool has_blocks = false;  ///< the window of rows holds accelerations, and there are no points
  bool modes = false;       ///< one direction more: the rows of the cell stabiliser
  bool viscous = false;     ///< `rows` act on velocities
  bool has_rows = false;
  bool body_force = false;
  std::vector<RegionLaw<D>> laws;
  std::vector<char> constrained;  ///< by booked node and component
  std::vector<double> pressures;  ///< of the loads, at t_n
};

/// What differs from step to step.
template <int D>
struct StepArguments {
  double* u = nullptr;
  double* v = nullptr;
  double kick = 0.0, dt = 0.0;
  const std::vector<double>* pressures = nullptr;
  BoundaryForces<D>* forces = nullptr;  ///< of a step, or
  State<D>* observed = nullptr;         ///< where H, P and f go instead of making one
};

template <int D>
class Worker {
 public:
  Worker(const SweepBody<D>& shared, WorkerPlan plan);

  /// Everything that reads nodes of other workers; false where a state has no stress.
  [[nodiscard]] bool before(const StepArguments<D>& step);
  /// The rest; nodes up to `reached` are at the new time when it fails.
  [[nodiscard]] bool after(const StepArguments<D>& step);

  /// Points whose H and P this worker writes when they are observed.
  void observe_points(Index first, Index last) {
    observed_first_ = first;
    observed_last_ = last;
  }
  [[nodiscard]] Index first_point() const { return plan_.points_first; }
  [[nodiscard]] Index first() const { return plan_.first_node; }
  [[nodiscard]] Index reached() const { return reached_; }
  double viscous_power = 0.0, viscous_power_after = 0.0;
  double largest_speed = 0.0;

 private:
  static constexpr int most_directions = D + 1;
  /// A window on fields by direction.
  struct Store {
    std::array<std::vector<double>, most_directions> field;
    std::array<double*, most_directions> direction{};
    Index base = 0;
    void allocate(int directions, Index rows, Index first);
    [[nodiscard]] Window window() { return {direction.data(), base}; }
    void shift(int directions, Index first, Index last);
    void copy_from(const Store& other, int directions, Index first, Index last);
  };

  [[nodiscard]] bool run(const std::vector<Task>& tasks, const StepArguments<D>& step);
  [[nodiscard]] bool points(const Task& task, Store& store, const StepArguments<D>& step);
  [[nodiscard]] bool rows(const Task& task, Store& store, const StepArguments<D>& step);
  void nodes(const Task& task, const StepArguments<D>& step);
  void observe(const Task& task, const StepArguments<D>& step);
  void accelerate(const Task& task, Runs some, const StepArguments<D>& step);
  void add_loads(const Task& task, const StepArguments<D>& step, double* a) const;
  void go_on(Runs some, const Motion& motion);
  void move_special(const Task& task, const StepArguments<D>& step, Motion motion);
  void book(const Task& task, const StepArguments<D>& step, double* a) const;
  void hold(const Task& task, const StepArguments<D>& step) const;
  [[nodiscard]] bool constrained(Index booked, int component) const;
  [[nodiscard]] double power(const Task& task, const StepArguments<D>& step) const;
  void write_points(const Task& task, const Store& store, TensorField<D>& field) const;
  [[nodiscard]] Runs runs(const std::vector<RowRun>& list, const Task& task) const {
    return {list.data() + task.run, task.runs};
  }
  [[nodiscard]] int directions() const { return shared_.modes ? D + 1 : D; }

  const SweepBody<D>& shared_;
  WorkerPlan plan_;
  Index size_;  // doubles in u
  Store points_, points_kept_, rows_, rows_kept_;
  std::vector<double> acceleration_;
  Index reached_ = 0;
  Index observed_first_ = 0, observed_last_ = 0;
};

}  // namespace tlsph::sweep

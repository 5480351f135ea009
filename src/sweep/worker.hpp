#pragma once
/// \file
/// One worker's part of a sweep: its plan, its windows, and the loop over its tasks.

#include <vector>

#include "fields.hpp"
#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/dynamics/balance.hpp"

namespace tlsph::sweep {

/// What all workers share, constant during a step.
template <int D>
struct SweepBody {
  const Discretisation<D>& discretisation;
  const Loops<D>& loops;
  std::vector<RegionLaw<D>> laws = {};
  Vector<D> body_force = Vector<D>::Zero();  ///< acceleration [m/s²]
  std::vector<char> constrained = {};        ///< by booked node and component
  std::vector<double> pressures = {};        ///< of the loads, at t_n
};

/// A step of the state, or an evaluation: H, P and f go into the state instead.
template <int D>
struct StepArguments {
  State<D>& state;
  BoundaryForces<D>* forces = nullptr;  ///< of a step
  double kick = 0.0, dt = 0.0;

  [[nodiscard]] bool observed() const { return forces == nullptr; }
};

template <int D>
class Worker {
 public:
  Worker(const SweepBody<D>& body, const Operators& operators, WorkerPlan plan);

  /// Everything that reads nodes of other workers; false where a state has no stress.
  [[nodiscard]] bool before(const StepArguments<D>& step);
  /// The rest; nodes up to `reached` are at the new time when it fails.
  [[nodiscard]] bool after(const StepArguments<D>& step) { return run(plan_.after, step); }

  /// Points whose H and P this worker writes when they are observed.
  Index first_observed = 0, last_observed = 0;
  [[nodiscard]] Index first_point() const { return plan_.points.first; }
  [[nodiscard]] Index first() const { return plan_.first_node; }
  [[nodiscard]] Index reached() const { return reached_; }
  double viscous_power = 0.0, viscous_power_after = 0.0;
  double largest_speed = 0.0;

 private:
  struct Stream {
    Fields<D> window, kept;
  };

  [[nodiscard]] bool run(const std::vector<Task>& tasks, const StepArguments<D>& step);
  [[nodiscard]] bool points(const Task& task, Fields<D>& to, const StepArguments<D>& step);
  [[nodiscard]] bool rows(const Task& task, Fields<D>& to, const StepArguments<D>& step);
  void observe_points(const Task& task, const Fields<D>& from, TensorField<D>& field) const;
  void move(const Task& task, const StepArguments<D>& step);
  void observe_nodes(const Task& task, State<D>& state);
  double* accelerate(const Task& task, Part some);
  void add_loads(const Task& task, double* a) const;
  void move_special(const Task& task, Part some, double* a, const StepArguments<D>& step,
                    Motion motion);
  [[nodiscard]] double power(const Task& task, const State<D>& state) const;
  [[nodiscard]] Runs runs(Part part) const { return {plan_.runs.data() + part.first, part.count}; }
  [[nodiscard]] const Products& products() const { return body_.loops.products[op_.modes]; }

  const SweepBody<D>& body_;
  const Operators& op_;
  WorkerPlan plan_;
  Stream points_, rows_;
  std::vector<double> acceleration_;
  Index reached_ = 0;
};

}  // namespace tlsph::sweep

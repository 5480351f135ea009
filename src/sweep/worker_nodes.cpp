/// What a worker does with the nodes of a block: forces, their records, moves.

#include <algorithm>

#include "worker.hpp"

namespace tlsph::sweep {

template <int D>
void Worker<D>::nodes(const Task& task, const StepArguments<D>& step) {
  if (step.observed != nullptr) return observe(task, step);
  const double* row = shared_.has_rows ? rows_.direction[0] : nullptr;
  Motion motion{step.kick, step.dt, step.v, step.u, row, rows_.base, {}};
  if (shared_.body_force)
    for (int i = 0; i < D; ++i) motion.body_force[i] = shared_.disc->body_force[i];
  if (shared_.viscous) viscous_power += power(task, step);
  if (shared_.has_blocks) {
    double* a = rows_.direction[0] + (task.first - rows_.base) * D;
    add_loads(task, step, a);
    book(task, step, a);
    go_on(runs(plan_.divergence, task), motion);
    hold(task, step);
  } else {
    const Runs free{plan_.free.data() + task.free, task.frees};
    const auto move = shared_.modes ? shared_.loops->move_with_modes : shared_.loops->move;
    largest_speed =
        std::max(largest_speed, move(shared_.divergence, free, points_.window(), motion));
    if (task.specials > 0) move_special(task, step, motion);
  }
  if (shared_.viscous) viscous_power_after += power(task, step);
  reached_ = task.last;
}

/// Accelerations of some nodes of a block, from its start.
template <int D>
void Worker<D>::accelerate(const Task& task, Runs some, const StepArguments<D>& step) {
  const Discretisation<D>& disc = *shared_.disc;
  const Loops<D>& loops = *shared_.loops;
  double* a = acceleration_.data();
  (shared_.modes ? loops.divergence_and_modes : loops.divergence)(shared_.divergence, some,
                                                                  points_.window(), a, task.first);
  for (Index r = 0; r < some.count; ++r) {
    const RowRun& run = some.run[r];
    double* own = a + (run.first - task.first) * D;
    const Index length = static_cast<Index>(run.count) * D;
    if (shared_.has_rows)
      loops.subtract(length, rows_.direction[0] + (run.first - rows_.base) * D, own);
    if (shared_.body_force)
      for (Index k = 0; k < length; ++k) own[k] += disc.body_force[k % D];
  }
  add_loads(task, step, a);
}

template <int D>
void Worker<D>::add_loads(const Task& task, const StepArguments<D>& step, double* a) const {
  for (Index k = task.load; k < task.load + task.loads; ++k) {
    const NodeLoad& load = plan_.loads[static_cast<std::size_t>(k)];
    a[load.dof - task.first * D] += (*step.pressures)[load.load] * load.weight;
  }
}

/// Rows that have their accelerations.
template <int D>
void Worker<D>::go_on(Runs some, const Motion& motion) {
  largest_speed = std::max(largest_speed, shared_.loops->move_on(some, motion));
}

template <int D>
void Worker<D>::observe(const Task& task, const StepArguments<D>& step) {
  const Discretisation<D>& disc = *shared_.disc;
  accelerate(task, runs(plan_.divergence, task), step);
  const Index length = (task.last - task.first) * D;
  for (Index k = 0; k < length; ++k)
    step.observed->f.data()[task.first * D + k] =
        disc.mass[task.first + k / D] * acceleration_[static_cast<std::size_t>(k)];
  if (!shared_.viscous) return;
  const double* row = rows_.direction[0] + (task.first - rows_.base) * D;
  for (Index k = 0; k < length; ++k)
    step.observed->viscous.data()[task.first * D + k] = disc.mass[task.first + k / D] * row[k];
}

/// Of the viscous forces on a block.
template <int D>
double Worker<D>::power(const Task& task, const StepArguments<D>& step) const {
  const double* row = rows_.direction[0] + (task.first - rows_.base) * D;
  const double* v = step.v + task.first * D;
  double sum = 0.0;
  for (Index k = 0; k < (task.last - task.first) * D; ++k)
    sum += shared_.disc->mass[task.first + k / D] * row[k] * v[k];
  return sum;
}

/// Loaded nodes, and those whose forces are gathered or whose motion is given.
template <int D>
void Worker<D>::move_special(const Task& task, const StepArguments<D>& step, Motion motion) {
  const Runs special{plan_.special.data() + task.special, task.specials};
  accelerate(task, special, step);
  book(task, step, acceleration_.data());
  motion.rows = acceleration_.data();
  motion.rows_base = task.first;
  go_on(special, motion);
  hold(task, step);
}

template <int D>
bool Worker<D>::constrained(Index booked, int component) const {
  return shared_.constrained[static_cast<std::size_t>(booked * D + component)] != 0;
}

/// Gathers the forces of the nodes of a block, from whose start `a` holds accelerations; those of
/// given motions become zero.
template <int D>
void Worker<D>::book(const Task& task, const StepArguments<D>& step, double* a) const {
  BoundaryForces<D>& forces = *step.forces;
  for (Index k = task.item; k < task.item + task.items; ++k) {
    const Index node = forces.nodes[static_cast<std::size_t>(k)];
    const double mass = shared_.disc->mass[node];
    for (int i = 0; i < D; ++i) {
      const Index dof = node * D + i;
      const Index local = dof - task.first * D;
      forces.f(k, i) = mass * a[local];
      forces.u(k, i) = step.u[dof];
      forces.v(k, i) = step.v[dof];
      if (constrained(k, i)) a[local] = 0.0;
    }
  }
}

/// A degree of freedom that is moved waits for its curve.
template <int D>
void Worker<D>::hold(const Task& task, const StepArguments<D>& step) const {
  const BoundaryForces<D>& forces = *step.forces;
  for (Index k = task.item; k < task.item + task.items; ++k)
    for (int i = 0; i < D; ++i)
      if (constrained(k, i))
        step.u[forces.nodes[static_cast<std::size_t>(k)] * D + i] = forces.u(k, i);
}

template void Worker<1>::nodes(const Task&, const StepArguments<1>&);
template void Worker<2>::nodes(const Task&, const StepArguments<2>&);

}  // namespace tlsph::sweep

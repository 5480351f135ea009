#include "worker.hpp"

#include <algorithm>

namespace tlsph::sweep {

template <int D>
Worker<D>::Worker(const SweepBody<D>& body, const Operators& operators, WorkerPlan plan)
    : body_(body),
      op_(operators),
      plan_(std::move(plan)),
      acceleration_(static_cast<std::size_t>(block_rows * D + overrun), 0.0) {
  const auto stream = [](int directions, const WorkerPlan::Window& window) {
    return Stream{Fields<D>(directions, window.size, window.first),
                  Fields<D>(directions, window.kept_count, window.kept)};
  };
  points_ = stream(op_.modes ? D + 1 : D, plan_.points);
  if (op_.has_rows) rows_ = stream(1, plan_.rows);
}

template <int D>
bool Worker<D>::before(const StepArguments<D>& step) {
  points_.window.base = plan_.points.first;
  rows_.window.base = plan_.rows.first;
  reached_ = plan_.first_node;
  viscous_power = viscous_power_after = largest_speed = 0.0;
  return run(plan_.before, step);
}

template <int D>
bool Worker<D>::run(const std::vector<Task>& tasks, const StepArguments<D>& step) {
  for (const Task& task : tasks) {
    Stream& stream = task.points ? points_ : rows_;
    switch (task.kind) {
      case Task::Kind::compute:
      case Task::Kind::keep: {
        Fields<D>& to = task.kind == Task::Kind::keep ? stream.kept : stream.window;
        if (!(task.points ? points(task, to, step) : rows(task, to, step))) return false;
        break;
      }
      case Task::Kind::copy:
        stream.window.copy_from(stream.kept, task.first, task.last);
        break;
      case Task::Kind::shift:
        stream.window.shift(task.first, task.last);
        break;
      case Task::Kind::move:
        move(task, step);
        break;
    }
  }
  return true;
}

template <int D>
bool Worker<D>::points(const Task& task, Fields<D>& to, const StepArguments<D>& step) {
  const VectorField<D>& u = step.state.u;
  const auto strain = [&](Part some) {
    products().gradient(op_.gradient, runs(some), u.data(), u.size(), to.window());
  };
  if (step.observed()) {
    strain(task.runs);
    observe_points(task, to, step.state.H);
  }
  bool good = true;
  for (Index k = task.laws.first; k < task.laws.first + task.laws.count; ++k) {
    const LawSegment& segment = plan_.laws[static_cast<std::size_t>(k)];
    const RegionLaw<D>& law = body_.laws[segment.region];
    if (step.observed() || law.loops == nullptr) {
      if (!step.observed()) strain(segment.runs);
      good = law.stress(to.directions(), segment.first - to.base, segment.count) && good;
    } else {
      good = law.loops->points[op_.modes](law.text(), op_.gradient, runs(segment.runs), u.data(),
                                          u.size(), to.window()) &&
             good;
    }
  }
  if (step.observed()) observe_points(task, to, step.state.P);
  return good;
}

template <int D>
void Worker<D>::observe_points(const Task& task, const Fields<D>& from,
                               TensorField<D>& field) const {
  if (field.rows() > 0)
    from.write(field, std::max(task.first, first_observed), std::min(task.last, last_observed));
}

template <int D>
bool Worker<D>::rows(const Task& task, Fields<D>& to, const StepArguments<D>& step) {
  const VectorField<D>& x = op_.viscous ? step.state.v : step.state.u;
  double* out = to.directions()[0];
  if (op_.blocks)
    return body_.loops.accelerations(op_.rows, runs(task.runs), runs(task.patches), x.data(),
                                     x.size(), body_.body_force.data(), out, to.base);
  body_.loops.differences(op_.rows, runs(task.runs), x.data(), x.size(), out, to.base);
  return true;
}

template <int D>
void Worker<D>::move(const Task& task, const StepArguments<D>& step) {
  State<D>& state = step.state;
  if (step.observed()) return observe_nodes(task, state);
  Motion motion{step.kick, step.dt, state.v.data(), state.u.data(), nullptr, rows_.window.base, {}};
  if (op_.has_rows) motion.rows = rows_.window.directions()[0];
  std::ranges::copy(body_.body_force, motion.body_force);
  if (op_.viscous) viscous_power += power(task, state);
  if (op_.blocks) {
    move_special(task, task.runs, rows_.window.at(task.first), step, motion);
  } else {
    largest_speed = std::max(largest_speed, products().move(op_.divergence, runs(task.free),
                                                            points_.window.window(), motion));
    if (task.special.count > 0)
      move_special(task, task.special, accelerate(task, task.special), step, motion);
  }
  if (op_.viscous) viscous_power_after += power(task, state);
  reached_ = task.last;
}

/// Accelerations of some nodes of a block but for loads, from its start.
template <int D>
double* Worker<D>::accelerate(const Task& task, Part some) {
  double* a = acceleration_.data();
  products().divergence(op_.divergence, runs(some), points_.window.window(), a, task.first);
  const bool body_force = !body_.body_force.isZero(0.0);
  for (Index r = 0; r < some.count; ++r) {
    const RowRun& run = runs(some).run[r];
    double* own = a + (run.first - task.first) * D;
    const Index length = static_cast<Index>(run.count) * D;
    if (op_.has_rows) body_.loops.subtract(length, rows_.window.at(run.first), own);
    if (body_force)
      for (Index k = 0; k < length; ++k) own[k] += body_.body_force[k % D];
  }
  return a;
}

template <int D>
void Worker<D>::add_loads(const Task& task, double* a) const {
  for (Index k = task.loads.first; k < task.loads.first + task.loads.count; ++k) {
    const NodeLoad& load = plan_.loads[static_cast<std::size_t>(k)];
    a[load.dof - task.first * D] += body_.pressures[load.load] * load.weight;
  }
}

template <int D>
void Worker<D>::observe_nodes(const Task& task, State<D>& state) {
  double* a = accelerate(task, task.runs);
  add_loads(task, a);
  const auto write = [&](const double* from, VectorField<D>& field) {
    for (Index q = task.first; q < task.last; ++q)
      for (int i = 0; i < D; ++i) field(q, i) = body_.discretisation.mass[q] * *from++;
  };
  write(a, state.f);
  if (op_.viscous) write(rows_.window.at(task.first), state.viscous);
}

/// Of the viscous forces on a block.
template <int D>
double Worker<D>::power(const Task& task, const State<D>& state) const {
  const double* row = rows_.window.at(task.first);
  const double* v = state.v.data() + task.first * D;
  double sum = 0.0;
  for (Index k = 0; k < (task.last - task.first) * D; ++k)
    sum += body_.discretisation.mass[task.first + k / D] * row[k] * v[k];
  return sum;
}

/// Nodes of a block, from whose start `a` holds accelerations, with loads, records of forces and
/// given motions: those accelerations become zero, and what a node is moved by is set later, by its
/// curve.
template <int D>
void Worker<D>::move_special(const Task& task, Part some, double* a, const StepArguments<D>& step,
                             Motion motion) {
  BoundaryForces<D>& forces = *step.forces;
  const auto for_booked = [&](const auto& act) {
    for (Index k = task.booked.first; k < task.booked.first + task.booked.count; ++k)
      for (int i = 0; i < D; ++i)
        act(k, i, forces.nodes[static_cast<std::size_t>(k)],
            body_.constrained[static_cast<std::size_t>(k * D + i)] != 0);
  };
  add_loads(task, a);
  for_booked([&](Index k, int i, Index node, bool constrained) {
    double& own = a[(node - task.first) * D + i];
    forces.f(k, i) = body_.discretisation.mass[node] * own;
    forces.u(k, i) = step.state.u(node, i);
    forces.v(k, i) = step.state.v(node, i);
    if (constrained) own = 0.0;
  });
  motion.rows = a;
  motion.rows_base = task.first;
  largest_speed = std::max(largest_speed, body_.loops.move_on(runs(some), motion));
  for_booked([&](Index k, int i, Index node, bool constrained) {
    if (constrained) step.state.u(node, i) = forces.u(k, i);
  });
}

template class Worker<1>;
template class Worker<2>;

}  // namespace tlsph::sweep

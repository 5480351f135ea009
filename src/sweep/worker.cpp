#include "worker.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace tlsph::sweep {
namespace {

std::size_t bytes(Index doubles) {
  return static_cast<std::size_t>(doubles) * sizeof(double);
}

/// A law without loops, point by point.
template <int D>
bool apply_any(const RegionLaw<D>& region, double* const* field, Index first, Index count) {
  double sum = 0.0;
  std::visit(
      [&](const auto& law) {
        for (Index s = first; s < first + count; ++s) {
          Tensor<D> H;
          for (int i = 0; i < D; ++i)
            for (int a = 0; a < D; ++a) H(i, a) = field[a][s * D + i];
          const Tensor<D> P =
              region.linearised ? law.dpk1(Tensor<D>::Zero(), H) : Tensor<D>(law.pk1(H));
          sum += P(0, 0);
          if (!region.linearised && !(law.margin(H) > 0.0))
            sum = std::numeric_limits<double>::quiet_NaN();
          for (int i = 0; i < D; ++i)
            for (int a = 0; a < D; ++a) field[a][s * D + i] = P(i, a);
        }
      },
      region.law);
  return std::isfinite(sum);
}

}  // namespace

template <int D>
void Worker<D>::Store::allocate(int directions, Index rows, Index first) {
  base = first;
  for (int a = 0; a < directions; ++a) {
    auto& values = field[static_cast<std::size_t>(a)];
    values.assign(static_cast<std::size_t>(rows * D + overrun), 0.0);
    direction[static_cast<std::size_t>(a)] = values.data();
  }
}

template <int D>
void Worker<D>::Store::shift(int directions, Index first, Index last) {
  for (int a = 0; a < directions; ++a) {
    double* values = direction[static_cast<std::size_t>(a)];
    std::memmove(values, values + (first - base) * D, bytes((last - first) * D));
  }
  base = first;
}

template <int D>
void Worker<D>::Store::copy_from(const Store& other, int directions, Index first, Index last) {
  for (int a = 0; a < directions; ++a)
    std::memcpy(direction[static_cast<std::size_t>(a)] + (first - base) * D,
                other.direction[static_cast<std::size_t>(a)] + (first - other.base) * D,
                bytes((last - first) * D));
}

template <int D>
Worker<D>::Worker(const SweepBody<D>& shared, WorkerPlan plan)
    : shared_(shared), plan_(std::move(plan)), size_(shared.disc->nodes() * D) {
  points_.allocate(directions(), plan_.points_window, plan_.points_first);
  points_kept_.allocate(directions(), plan_.points_kept_count, plan_.points_kept);
  if (shared_.has_rows) {
    rows_.allocate(1, plan_.rows_window, plan_.first_node);
    rows_kept_.allocate(1, plan_.rows_kept_count, plan_.rows_kept);
  }
  acceleration_.assign(static_cast<std::size_t>(block_rows * D + overrun), 0.0);
}

template <int D>
bool Worker<D>::before(const StepArguments<D>& step) {
  points_.base = plan_.points_first;
  rows_.base = plan_.first_node;
  reached_ = plan_.first_node;
  viscous_power = viscous_power_after = largest_speed = 0.0;
  return run(plan_.before, step);
}

template <int D>
bool Worker<D>::after(const StepArguments<D>& step) {
  return run(plan_.after, step);
}

template <int D>
bool Worker<D>::run(const std::vector<Task>& tasks, const StepArguments<D>& step) {
  for (const Task& task : tasks) switch (task.kind) {
      case Task::Kind::points:
        if (!points(task, points_, step)) return false;
        break;
      case Task::Kind::points_kept:
        if (!points(task, points_kept_, step)) return false;
        break;
      case Task::Kind::points_copy:
        points_.copy_from(points_kept_, directions(), task.first, task.last);
        break;
      case Task::Kind::points_shift:
        points_.shift(directions(), task.first, task.last);
        break;
      case Task::Kind::rows:
        if (!rows(task, rows_, step)) return false;
        break;
      case Task::Kind::rows_kept:
        if (!rows(task, rows_kept_, step)) return false;
        break;
      case Task::Kind::rows_copy:
        rows_.copy_from(rows_kept_, 1, task.first, task.last);
        break;
      case Task::Kind::rows_shift:
        rows_.shift(1, task.first, task.last);
        break;
      case Task::Kind::nodes:
        nodes(task, step);
        break;
    }
  return true;
}

template <int D>
bool Worker<D>::points(const Task& task, Store& store, const StepArguments<D>& step) {
  const bool observed = step.observed != nullptr;
  const Loops<D>& loops = *shared_.loops;
  const auto strain = [&](Runs some) {
    (shared_.modes ? loops.gradient_and_modes : loops.gradient)(shared_.gradient, some, step.u,
                                                                size_, store.window());
  };
  if (observed) {
    strain(runs(plan_.gradient, task));
    write_points(task, store, step.observed->H);
  }
  bool good = true;
  for (Index k = task.item; k < task.item + task.items; ++k) {
    const LawSegment& segment = plan_.laws[static_cast<std::size_t>(k)];
    const Runs own{plan_.gradient.data() + segment.run, segment.runs};
    const RegionLaw<D>& law = shared_.laws[segment.region];
    const Index first = segment.first - store.base;
    double* const* field = store.direction.data();
    if (law.loops == nullptr) {
      if (!observed) strain(own);
      good = apply_any<D>(law, field, first, segment.count) && good;
    } else if (observed) {
      good = law.loops->stress(law.text(), field, first, segment.count) && good;
    } else {
      const auto stress = shared_.modes ? law.loops->points_and_modes : law.loops->points;
      good = stress(law.text(), shared_.gradient, own, step.u, size_, store.window()) && good;
    }
  }
  if (observed) write_points(task, store, step.observed->P);
  return good;
}

template <int D>
void Worker<D>::write_points(const Task& task, const Store& store, TensorField<D>& field) const {
  if (field.rows() == 0) return;
  const Index first = std::max(task.first, observed_first_);
  const Index last = std::min(task.last, observed_last_);
  for (Index s = first; s < last; ++s)
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        field.data()[s * D * D + i * D + a] =
            store.direction[static_cast<std::size_t>(a)][(s - store.base) * D + i];
}

template <int D>
bool Worker<D>::rows(const Task& task, Store& store, const StepArguments<D>& step) {
  if (shared_.has_blocks) {
    Vector<D> g = Vector<D>::Zero();
    if (shared_.body_force) g = shared_.disc->body_force;
    return shared_.loops->accelerations(shared_.blocks, runs(plan_.rows, task),
                                        {plan_.rows.data() + task.patch, task.patches}, step.u,
                                        size_, g.data(), store.direction[0], store.base);
  }
  shared_.loops->differences(shared_.rows, runs(plan_.rows, task),
                             shared_.viscous ? step.v : step.u, size_, store.direction[0],
                             store.base);
  return true;
}

template class Worker<1>;
template class Worker<2>;

}  // namespace tlsph::sweep

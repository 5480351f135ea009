#include "plan.hpp"

#include <algorithm>
#include <limits>

#include "tlsph/operators/row_storage.hpp"

namespace tlsph::sweep {
namespace {

std::size_t at(Index k) {
  return static_cast<std::size_t>(k);
}

template <class Item>
Index size_of(const std::vector<Item>& list) {
  return static_cast<Index>(list.size());
}

/// Rows [first, last) of a stream. Those before `early` and from `late` on read what belongs to
/// other workers.
struct Stream {
  const StreamRows* rows = nullptr;
  bool points = false;
  Index first = 0, last = 0, early = 0, late = 0;
  Index done = 0, base = 0, size = 1;
  std::vector<Index> needed, live;  // by block of nodes

  /// Which rows read nodes that are not in [first_node, last_node).
  void find_foreign(Index first_node, Index last_node) {
    early = first;
    late = last;
    for (Index s = first; s < last; ++s) {
      if (rows->high[at(s)] < 0) continue;
      if (rows->low[at(s)] < first_node) early = s + 1;
      if (rows->high[at(s)] >= last_node) late = std::min(late, s);
    }
    if (late < early) early = late = last;
  }

  void size_window() {
    constexpr Index large = 1 << 14;  // rows; beyond it room costs more cache than shifts cost time
    Index widest = early - first;
    for (std::size_t b = 0; b < needed.size(); ++b)
      widest = std::max(widest, std::max(needed[b], early) - live[b]);
    widest += block_rows;
    size = std::min(widest < large ? 3 * widest : widest + widest / 2,
                    std::max<Index>(last - first, 1));
  }

  [[nodiscard]] WorkerPlan::Window window() const { return {first, size, late, last - late}; }
};

class Planner {
 public:
  Planner(const PlanInput& input, Index first, Index last, bool alone) : in_(input) {
    plan_.first_node = first;
    plan_.last_node = last;
    for (Index q = first; q < last; q += block_rows) edges_.push_back(q);
    edges_.push_back(last);
    points_ = stream(input.points, alone);
    points_.points = true;
    rows_ = stream(input.rows, alone);
  }

  WorkerPlan make() {
    plan_.points = points_.window();
    plan_.rows = rows_.window();
    for (Stream* stream : {&points_, &rows_}) {
      compute(*stream, Task::Kind::compute, stream->first, stream->early, plan_.before);
      compute(*stream, Task::Kind::keep, stream->late, stream->last, plan_.before);
      stream->done = stream->early;
    }
    for (std::size_t b = 0; b + 1 < edges_.size(); ++b) {
      for (Stream* stream : {&points_, &rows_}) follow(*stream, stream->needed[b], stream->live[b]);
      move(edges_[b], edges_[b + 1]);
    }
    follow(points_, points_.last, points_.last);  // points that no node waits for have a law too
    return std::move(plan_);
  }

 private:
  [[nodiscard]] Stream stream(const StreamRows& rows, bool alone) const {
    const std::size_t blocks = edges_.size() - 1;
    Stream result;
    result.rows = &rows;
    result.needed.assign(blocks, 0);
    result.live.assign(blocks, 0);
    if (rows.count == 0) return result;
    const auto low = [&](Index q) -> Index {
      return rows.moving_low.empty() ? q : rows.moving_low[at(q)];
    };
    const auto end = [&](Index q) -> Index {
      return rows.moving_high.empty() ? q + 1 : rows.moving_high[at(q)] + 1;
    };
    Index first = std::numeric_limits<Index>::max();
    Index last = 0;
    for (Index q = plan_.first_node; q < plan_.last_node; ++q) {
      if (end(q) == 0) continue;
      first = std::min(first, low(q));
      last = std::max(last, end(q));
    }
    if (alone) {
      first = 0;
      last = rows.count;
    }
    result.first = result.done = result.base = std::min(first, last);
    result.last = last;
    result.find_foreign(plan_.first_node, plan_.last_node);
    Index most = result.first;
    for (std::size_t b = 0; b < blocks; ++b) {
      for (Index q = edges_[b]; q < edges_[b + 1]; ++q)
        most = std::max({most, end(q), Index{rows.readers[at(q)]} + 1});
      result.needed[b] = std::min(most, last);
    }
    Index live = last;
    for (std::size_t b = blocks; b-- > 0;) {
      for (Index q = edges_[b]; q < edges_[b + 1]; ++q)
        if (end(q) > 0) live = std::min(live, low(q));
      result.live[b] = live;
    }
    result.size_window();
    return result;
  }

  Part append(const std::vector<RowRun>& runs, Index first, Index last) {
    const Index start = append_runs(runs, first, last, plan_.runs);
    return {start, size_of(plan_.runs) - start};
  }

  void compute(const Stream& stream, Task::Kind kind, Index first, Index last,
               std::vector<Task>& tasks) {
    for (Index from = first; from < last; from += block_rows) {
      Task task{.kind = kind,
                .points = stream.points,
                .first = from,
                .last = std::min(from + block_rows, last)};
      if (stream.points)
        add_laws(task);
      else
        task.runs = append(*stream.rows->runs, task.first, task.last);
      if (stream.rows->patches != nullptr)
        task.patches = append(*stream.rows->patches, task.first, task.last);
      tasks.push_back(task);
    }
  }

  void add_laws(Task& task) {
    task.runs.first = size_of(plan_.runs);
    task.laws.first = size_of(plan_.laws);
    for_laws(in_.regions, task.first, task.last, [&](std::size_t region, Index first, Index last) {
      plan_.laws.push_back({region, first, last - first, append(*in_.points.runs, first, last)});
    });
    task.runs.count = size_of(plan_.runs) - task.runs.first;
    task.laws.count = size_of(plan_.laws) - task.laws.first;
  }

  void follow(Stream& stream, Index need, Index live) {
    while (stream.done < need) {
      const bool kept = stream.done >= stream.late;
      const Index end = std::min(stream.done + block_rows,
                                 kept ? stream.last : std::min(stream.late, stream.last));
      if (end - stream.base > stream.size) {
        stream.base = std::min(live, stream.done);
        plan_.after.push_back({.kind = Task::Kind::shift,
                               .points = stream.points,
                               .first = stream.base,
                               .last = stream.done});
      }
      if (kept)
        plan_.after.push_back(
            {.kind = Task::Kind::copy, .points = stream.points, .first = stream.done, .last = end});
      else
        compute(stream, Task::Kind::compute, stream.done, end, plan_.after);
      stream.done = end;
    }
  }

  void move(Index first, Index last) {
    Task task{.kind = Task::Kind::move, .first = first, .last = last};
    task.runs = append(*in_.nodes, first, last);
    const auto from = std::ranges::lower_bound(in_.booked, first);
    task.booked = {from - in_.booked.begin(),
                   std::lower_bound(from, in_.booked.end(), last) - from};
    const auto load_of = [&](Index node) {
      return std::ranges::lower_bound(in_.loads, node * in_.components, {}, &NodeLoad::dof);
    };
    task.loads = {size_of(plan_.loads), load_of(last) - load_of(first)};
    plan_.loads.insert(plan_.loads.end(), load_of(first), load_of(last));
    divide_nodes(task);
    plan_.after.push_back(task);
  }

  /// Booked and loaded nodes wait for more than the divergence; the others move at once.
  void divide_nodes(Task& task) {
    auto booked = in_.booked.begin() + task.booked.first;
    auto load = plan_.loads.begin() + task.loads.first;
    const auto is_special = [&](Index q) {
      while (booked != in_.booked.end() && *booked < q) ++booked;
      while (load != plan_.loads.end() && load->dof / in_.components < q) ++load;
      return (booked != in_.booked.end() && *booked == q) ||
             (load != plan_.loads.end() && load->dof / in_.components == q);
    };
    std::vector<RowRun> special_runs;
    task.free.first = size_of(plan_.runs);
    for (Index q = task.first; q < task.last;) {
      const bool special = is_special(q);
      Index end = q + 1;
      while (end < task.last && is_special(end) == special) ++end;
      append_runs(*in_.nodes, q, end, special ? special_runs : plan_.runs);
      q = end;
    }
    task.free.count = size_of(plan_.runs) - task.free.first;
    task.special = {size_of(plan_.runs), size_of(special_runs)};
    plan_.runs.insert(plan_.runs.end(), special_runs.begin(), special_runs.end());
  }

  const PlanInput& in_;
  std::vector<Index> edges_;  // of the blocks of nodes
  Stream points_, rows_;
  WorkerPlan plan_;
};

}  // namespace

WorkerPlan make_plan(const PlanInput& input, Index first, Index last, bool alone) {
  return Planner(input, first, last, alone).make();
}

}  // namespace tlsph::sweep

#include "plan.hpp"

#include <algorithm>
#include <limits>

namespace tlsph::sweep {
namespace {

/// A range of rows that a thread computes in order through a moving window. Those before `early`
/// and from `late` on read what belongs to other threads.
struct Stream {
  Task::Kind compute, keep, copy, shift;
  Index first = 0, last = 0, early = 0, late = 0;
  Index done = 0, base = 0, window = 0;
};

class Planner {
 public:
  Planner(const Dependences& dependences, const Operators& operators,
          const std::vector<int>& regions, const std::vector<Index>& booked,
          const std::vector<NodeLoad>& loads, int components, Index first, Index last, bool alone)
      : dep_(dependences),
        op_(operators),
        regions_(regions),
        booked_(booked),
        loads_(loads),
        components_(components) {
    plan_.first_node = first;
    plan_.last_node = last;
    find_blocks();
    points_ = point_stream(alone);
    rows_ = row_stream(alone);
    size_window(points_, needed_points_, live_points_);
    size_window(rows_, needed_rows_, live_rows_);
  }

  WorkerPlan make() {
    before(points_);
    before(rows_);
    for (std::size_t b = 0; b + 1 < edges_.size(); ++b) {
      follow(points_, needed_points_[b], live_points_[b]);
      follow(rows_, needed_rows_[b], live_rows_[b]);
      nodes(edges_[b], edges_[b + 1]);
    }
    follow(points_, points_.last, points_.last);  // points that no node waits for have a law too
    plan_.points_first = points_.first;
    plan_.points_window = points_.window;
    plan_.points_kept = points_.late;
    plan_.points_kept_count = points_.last - points_.late;
    plan_.rows_window = rows_.window;
    plan_.rows_kept = rows_.late;
    plan_.rows_kept_count = rows_.last - rows_.late;
    return std::move(plan_);
  }

 private:
  static std::size_t at(Index k) { return static_cast<std::size_t>(k); }

  void find_blocks() {
    for (Index q = plan_.first_node; q < plan_.last_node; q += block_rows) edges_.push_back(q);
    edges_.push_back(plan_.last_node);
  }

  Stream point_stream(bool alone) {
    Stream stream{Task::Kind::points, Task::Kind::points_kept, Task::Kind::points_copy,
                  Task::Kind::points_shift};
    Index low = std::numeric_limits<Index>::max();
    Index high = 0;
    for (Index q = plan_.first_node; q < plan_.last_node; ++q) {
      if (dep_.divergence_high[at(q)] < 0) continue;
      low = std::min<Index>(low, dep_.divergence_low[at(q)]);
      high = std::max<Index>(high, dep_.divergence_high[at(q)] + 1);
    }
    if (alone) {
      low = 0;
      high = dep_.points;
    }
    if (low > high) low = high;
    bound(stream, low, high, dep_.gradient_low, dep_.gradient_high);
    needed_points_ = needed(dep_.divergence_high, dep_.point_readers, stream);
    live_points_.assign(edges_.size() - 1, high);
    Index live = high;
    for (std::size_t b = edges_.size() - 1; b-- > 0;) {
      for (Index q = edges_[b]; q < edges_[b + 1]; ++q)
        if (dep_.divergence_high[at(q)] >= 0)
          live = std::min<Index>(live, dep_.divergence_low[at(q)]);
      live_points_[b] = live;
    }
    return stream;
  }

  Stream row_stream(bool) {
    Stream stream{Task::Kind::rows, Task::Kind::rows_kept, Task::Kind::rows_copy,
                  Task::Kind::rows_shift};
    needed_rows_.assign(edges_.size() - 1, plan_.first_node);
    live_rows_ = needed_rows_;
    if (op_.rows == nullptr) {
      stream.first = stream.last = stream.early = stream.late = stream.done = plan_.first_node;
      stream.base = plan_.first_node;
      return stream;
    }
    bound(stream, plan_.first_node, plan_.last_node, dep_.rows_low, dep_.rows_high);
    needed_rows_ = needed({}, dep_.row_readers, stream);
    for (std::size_t b = 0; b + 1 < edges_.size(); ++b) {
      needed_rows_[b] = std::max(needed_rows_[b], edges_[b + 1]);
      live_rows_[b] = edges_[b];
    }
    return stream;
  }

  /// Which rows of [first, last) read nodes of others.
  void bound(Stream& stream, Index first, Index last, const std::vector<int>& low,
             const std::vector<int>& high) const {
    stream.first = stream.early = stream.done = stream.base = first;
    stream.last = stream.late = last;
    for (Index s = first; s < last; ++s) {
      if (high[at(s)] < 0) continue;
      if (low[at(s)] < plan_.first_node) stream.early = s + 1;
      if (high[at(s)] >= plan_.last_node) stream.late = std::min(stream.late, s);
    }
    if (stream.late < stream.early) stream.early = stream.late = last;
  }

  /// How far a stream must have come before the nodes of a block may change.
  [[nodiscard]] std::vector<Index> needed(const std::vector<int>& read,
                                          const std::vector<int>& readers,
                                          const Stream& stream) const {
    std::vector<Index> result(edges_.size() - 1, stream.first);
    Index most = stream.first;
    for (std::size_t b = 0; b + 1 < edges_.size(); ++b) {
      for (Index q = edges_[b]; q < edges_[b + 1]; ++q) {
        if (!read.empty()) most = std::max<Index>(most, read[at(q)] + 1);
        most = std::max<Index>(most, readers[at(q)] + 1);
      }
      result[b] = std::min(most, stream.last);
    }
    return result;
  }

  static void size_window(Stream& stream, const std::vector<Index>& need,
                          const std::vector<Index>& live) {
    constexpr Index large = 1 << 14;  // rows; beyond it room costs more cache than shifts cost time
    Index widest = stream.early - stream.first;
    for (std::size_t b = 0; b < need.size(); ++b)
      widest = std::max(widest, std::max(need[b], stream.early) - live[b]);
    widest += block_rows;
    stream.window = std::min(widest < large ? 3 * widest : widest + widest / 2,
                             std::max<Index>(stream.last - stream.first, 1));
  }

  void compute(Stream& stream, Task::Kind kind, Index first, Index last, std::vector<Task>& tasks) {
    for (Index from = first; from < last; from += block_rows) {
      const Index end = std::min(from + block_rows, last);
      const bool points = &stream == &points_;
      std::vector<RowRun>& runs = points ? plan_.gradient : plan_.rows;
      Task task;
      task.kind = kind;
      task.first = from;
      task.last = end;
      task.run = static_cast<Index>(runs.size());
      if (points) {
        task.item = static_cast<Index>(plan_.laws.size());
        add_laws(from, end);
        task.items = static_cast<Index>(plan_.laws.size()) - task.item;
      } else {
        append_runs(*op_.rows, from, end, runs);
      }
      task.runs = static_cast<Index>(runs.size()) - task.run;
      if (!points && op_.patches != nullptr) {
        task.patch = append_runs(*op_.patches, from, end, runs);
        task.patches = static_cast<Index>(runs.size()) - task.patch;
      }
      tasks.push_back(task);
    }
  }

  void before(Stream& stream) {
    compute(stream, stream.compute, stream.first, stream.early, plan_.before);
    compute(stream, stream.keep, stream.late, stream.last, plan_.before);
    stream.done = stream.early;
  }

  void make_room(Stream& stream, Index end, Index live) {
    if (end - stream.base <= stream.window) return;
    Task task;
    task.kind = stream.shift;
    task.first = std::min(live, stream.done);
    task.last = stream.done;
    plan_.after.push_back(task);
    stream.base = task.first;
  }

  void follow(Stream& stream, Index need, Index live) {
    while (stream.done < need) {
      Index end = std::min(stream.done + block_rows, stream.last);
      if (stream.done < stream.late) end = std::min(end, stream.late);
      make_room(stream, end, live);
      if (stream.done < stream.late) {
        compute(stream, stream.compute, stream.done, end, plan_.after);
      } else {
        Task task;
        task.kind = stream.copy;
        task.first = stream.done;
        task.last = end;
        plan_.after.push_back(task);
      }
      stream.done = end;
    }
  }

  /// Segments of rows [first, last) with one law each.
  void add_laws(Index first, Index last) {
    for (Index s = first; s < last;) {
      LawSegment segment;
      segment.first = s;
      if (!regions_.empty()) segment.region = static_cast<std::size_t>(regions_[at(s)]);
      Index end = regions_.empty() ? last : s + 1;
      while (end < last && static_cast<std::size_t>(regions_[at(end)]) == segment.region) ++end;
      segment.count = end - s;
      segment.run = append_runs(*op_.gradient, s, end, plan_.gradient);
      segment.runs = static_cast<Index>(plan_.gradient.size()) - segment.run;
      plan_.laws.push_back(segment);
      s = end;
    }
  }

  void nodes(Index first, Index last) {
    Task task;
    task.kind = Task::Kind::nodes;
    task.first = first;
    task.last = last;
    task.run = append_runs(*op_.divergence, first, last, plan_.divergence);
    task.runs = static_cast<Index>(plan_.divergence.size()) - task.run;
    const auto from = std::ranges::lower_bound(booked_, first);
    task.item = from - booked_.begin();
    task.items = std::lower_bound(from, booked_.end(), last) - from;
    const auto before_dof = [](const NodeLoad& load, Index dof) { return load.dof < dof; };
    const auto begin =
        std::lower_bound(loads_.begin(), loads_.end(), first * components_, before_dof);
    const auto end = std::lower_bound(begin, loads_.end(), last * components_, before_dof);
    task.load = static_cast<Index>(plan_.loads.size());
    plan_.loads.insert(plan_.loads.end(), begin, end);
    task.loads = static_cast<Index>(plan_.loads.size()) - task.load;
    divide_nodes(task);
    plan_.after.push_back(task);
  }

  /// Booked and loaded nodes wait for more than the divergence; the others move at once.
  void divide_nodes(Task& task) {
    task.free = static_cast<Index>(plan_.free.size());
    task.special = static_cast<Index>(plan_.special.size());
    auto booked = booked_.begin() + task.item;
    auto load = plan_.loads.begin() + task.load;
    const auto is_special = [&](Index q) {
      while (booked != booked_.end() && *booked < q) ++booked;
      while (load != plan_.loads.end() && load->dof / components_ < q) ++load;
      return (booked != booked_.end() && *booked == q) ||
             (load != plan_.loads.end() && load->dof / components_ == q);
    };
    for (Index q = task.first; q < task.last;) {
      const bool special = is_special(q);
      Index end = q + 1;
      while (end < task.last && is_special(end) == special) ++end;
      append_runs(*op_.divergence, q, end, special ? plan_.special : plan_.free);
      q = end;
    }
    task.frees = static_cast<Index>(plan_.free.size()) - task.free;
    task.specials = static_cast<Index>(plan_.special.size()) - task.special;
  }

  const Dependences& dep_;
  const Operators& op_;
  const std::vector<int>& regions_;
  const std::vector<Index>& booked_;
  const std::vector<NodeLoad>& loads_;
  int components_;
  std::vector<Index> edges_;  // of the blocks of nodes
  Stream points_, rows_;
  std::vector<Index> needed_points_, live_points_, needed_rows_, live_rows_;
  WorkerPlan plan_;
};

}  // namespace

WorkerPlan make_plan(const Dependences& dependences, const Operators& operators,
                     const std::vector<int>& regions, const std::vector<Index>& booked,
                     const std::vector<NodeLoad>& loads, int components, Index first, Index last,
                     bool alone) {
  return Planner(dependences, operators, regions, booked, loads, components, first, last, alone)
      .make();
}

}  // namespace tlsph::sweep

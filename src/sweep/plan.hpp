#pragma once
/// \file
/// In which order a worker passes over its share of the body.
///
/// It moves its nodes block by block. What they are moved by are rows of two streams, of material
/// points and of S or C, each computed in order into a window that moves along the body:
///
///     rows     first          base    live                 done          base + size      last
///                ├──────────────┼───────┼────────────────────┼────────────────┼─────────────┤
///                   forgotten      not     wanted by nodes       room for the    not computed
///                                 wanted   that have not moved   next ones
///
///     nodes      ├──── at t_{n+1} ─────┤  block  ├───────────── at t_n ─────────────────────┤
///
/// Before a block moves, a stream is `done` up to the last row that moves one of its nodes or reads
/// it. Rows from `live` on, the first that moves a node of this or a later block, are kept: where
/// the window is full, [live, done) shifts to its start. Rows that read nodes of other workers are
/// computed before any worker moves one: the first of a stream in its window, the last ones in a
/// store from which they are copied when their turn comes.

#include <vector>

#include "loops.hpp"
#include "tlsph/core/types.hpp"

namespace tlsph::sweep {

/// So many entries of a list.
struct Part {
  Index first = 0, count = 0;
};

/// What a worker does next, with rows [first, last).
struct Task {
  enum class Kind {
    compute,  ///< H = G u and P of points, or S u or C v of nodes, into the window
    keep,     ///< the same into the store
    copy,     ///< from the store into the window
    shift,    ///< the window starts at `first` from now on, what it holds up to `last` stays
    move,     ///< nodes: forces and update
  };
  Kind kind = Kind::move;
  bool points = false;  ///< the stream of points, not that of rows of S or C
  Index first = 0, last = 0;
  Part runs = {};                ///< of the operator that the task applies
  Part patches = {};             ///< rows: runs that come second
  Part free = {}, special = {};  ///< nodes: runs without load or constraint, and the others
  Part laws = {};                ///< points: law segments
  Part booked = {};              ///< nodes whose forces are gathered
  Part loads = {};               ///< loaded degrees of freedom of nodes
};

/// Material points of one law, consecutive, and the runs that make them up.
struct LawSegment {
  std::size_t region = 0;
  Index first = 0, count = 0;
  Part runs;
};

/// a[dof] += value(load curve) · weight
struct NodeLoad {
  Index dof = 0;
  double weight = 0.0;  ///< over the mass
  std::size_t load = 0;
};

struct WorkerPlan {
  /// Of a stream.
  struct Window {
    Index first = 0, size = 1;
    Index kept = 0, kept_count = 0;  ///< rows in the store
  };
  Index first_node = 0, last_node = 0;
  std::vector<Task> before;  ///< of everything that reads nodes of other workers
  std::vector<Task> after;   ///< when all workers have done theirs
  std::vector<RowRun> runs;
  std::vector<LawSegment> laws;
  std::vector<NodeLoad> loads;
  Window points, rows;
};

/// Nodes and points of a block: their fields stay in the first-level cache.
inline constexpr Index block_rows = 512;

/// The rows of a stream, what they read and what they move.
struct StreamRows {
  Index count = 0;  ///< zero: there is no such stream
  const std::vector<RowRun>* runs = nullptr;
  const std::vector<RowRun>* patches = nullptr;  ///< runs that come after those, if there are any
  std::vector<int> low, high;                ///< nodes that a row reads; `high` is −1 for none
  std::vector<int> readers;                  ///< the last row that reads a node, or −1
  std::vector<int> moving_low, moving_high;  ///< rows that move a node; empty: its own row
};

/// What the plan of a worker is made from.
struct PlanInput {
  StreamRows points, rows;
  const std::vector<RowRun>* nodes = nullptr;  ///< runs of the divergence
  std::vector<int> regions;     ///< the law of every material point; empty: all have the first
  std::vector<Index> booked;    ///< nodes whose forces are gathered, ascending
  std::vector<NodeLoad> loads;  ///< ascending
  int components = 1;
};

/// The plan of the worker that owns nodes [first, last); `alone`: and all points.
[[nodiscard]] WorkerPlan make_plan(const PlanInput& input, Index first, Index last, bool alone);

/// visit(region, first, last) for the pieces of points [first, last) that have one law each.
template <class Visit>
void for_laws(const std::vector<int>& regions, Index first, Index last, const Visit& visit) {
  while (first < last) {
    const auto region = [&](Index s) { return regions[static_cast<std::size_t>(s)]; };
    Index end = regions.empty() ? last : first + 1;
    while (end < last && region(end) == region(first)) ++end;
    visit(regions.empty() ? std::size_t{0} : static_cast<std::size_t>(region(first)), first, end);
    first = end;
  }
}

}  // namespace tlsph::sweep

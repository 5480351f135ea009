#pragma once
/// \file
/// In which order a worker passes over its share of the body.

#include <vector>

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph::sweep {

/// What a worker does next. Ranges of rows, with the runs that make them up.
struct Task {
  enum class Kind {
    points,       ///< H = G u and P of material points, into the window
    points_kept,  ///< the same into the store of those that reach into the next thread's nodes
    points_copy,  ///< from that store into the window
    rows,         ///< S u or C v of nodes, into their window
    rows_kept,
    rows_copy,
    points_shift,  ///< the window starts at `first` from now on, what it holds up to `last` stays
    rows_shift,
    nodes,  ///< forces and update
  };
  Kind kind = Kind::nodes;
  Index first = 0, last = 0;
  Index run = 0, runs = 0;       ///< in the list of runs of the operator the task applies
  Index patch = 0, patches = 0;  ///< rows: behind them in that list, runs that come second
  /// nodes: runs in the lists `free`, nodes without load or constraint, and `special`, the others
  Index free = 0, frees = 0, special = 0, specials = 0;
  Index item = 0, items = 0;  ///< points: law segments; nodes: those whose forces are gathered
  Index load = 0, loads = 0;  ///< nodes: loaded degrees of freedom
};

/// Material points of one law, consecutive, and the runs that make them up.
struct LawSegment {
  std::size_t region = 0;
  Index first = 0, count = 0;
  Index run = 0, runs = 0;
};

/// a[dof] += value(load curve) · weight
struct NodeLoad {
  Index dof = 0;
  double weight = 0.0;  ///< over the mass
  std::size_t load = 0;
};

struct WorkerPlan {
  Index first_node = 0, last_node = 0;
  std::vector<Task> before;  ///< of everything that reads nodes of other threads
  std::vector<Task> after;   ///< when all threads have done theirs
  std::vector<RowRun> gradient, divergence, rows;
  std::vector<RowRun> free, special;  ///< of the divergence: nodes without and with conditions
  std::vector<LawSegment> laws;
  std::vector<NodeLoad> loads;
  Index points_first = 0, points_window = 0, points_kept = 0, points_kept_count = 0;
  Index rows_window = 0, rows_kept = 0, rows_kept_count = 0;
};

/// Nodes and points of a block: their fields stay in the first-level cache.
inline constexpr Index block_rows = 512;

/// What the plan of a worker is made from.
struct Dependences {
  std::vector<int> gradient_low, gradient_high;      ///< nodes a material point reads
  std::vector<int> divergence_low, divergence_high;  ///< points a node reads
  std::vector<int> point_readers;                    ///< the last point that reads a node, or −1
  std::vector<int> rows_low, rows_high;              ///< nodes that a row of S or C reads; or empty
  std::vector<int> row_readers;                      ///< the last row of S or C that reads a node
  Index points = 0, nodes = 0;
};

struct Operators {
  const std::vector<RowRun>* gradient = nullptr;
  const std::vector<RowRun>* divergence = nullptr;
  const std::vector<RowRun>* rows = nullptr;     ///< of S or C, nullptr if there is none
  const std::vector<RowRun>* patches = nullptr;  ///< runs that come after those, if there are any
};

/// The plan of the worker that owns nodes [first, last). `regions` gives the law of every material
/// point; empty: all have the first. `booked` are the nodes whose forces are gathered, `loads`
/// loaded degrees of freedom, both ascending.
[[nodiscard]] WorkerPlan make_plan(const Dependences& dependences, const Operators& operators,
                                   const std::vector<int>& regions,
                                   const std::vector<Index>& booked,
                                   const std::vector<NodeLoad>& loads, int components, Index first,
                                   Index last, bool alone);

}  // namespace tlsph::sweep

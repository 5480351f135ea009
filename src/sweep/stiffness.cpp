#include "stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tlsph::sweep {
namespace {

/// The run with that row in it; runs are ascending and leave no row out.
const RowRun& run_of(const std::vector<RowRun>& runs, Index row) {
  return *(std::ranges::upper_bound(runs, row, {}, &RowRun::first) - 1);
}

Row<double> row_of(const RowStorage& rows, const RowWeights& table, const RowRun& run, Index row) {
  return run.stencil == no_stencil ? general_row(table, table.weight, rows.stride, row)
                                   : stencil_row(table, rows.stride, run, row);
}

template <int D>
class Composer {
 public:
  Composer(const Discretisation<D>& body, const Storage<D>& storage,
           const std::vector<RegionLaw<D>>& laws, Index most_stencils)
      : storage_(storage), most_stencils_(most_stencils) {
    for (const RegionLaw<D>& law : laws)
      tangents_.push_back(tangent<D>(law.law, Tensor<D>::Zero()));
    if (const std::vector<int> regions = regions_of_points(body); !regions.empty())
      for_laws(regions, 0, body.points.size(), [&](std::size_t region, Index first, Index last) {
        regions_.push_back(
            {static_cast<int>(first), static_cast<int>(last - first), 0, static_cast<int>(region)});
      });
    result_.rows.stencil_start = {0};
    result_.rows.stride = block_weights<D>;
  }

  std::optional<Stiffness<D>> compose() {
    Index general = 0;
    for (const RowRun& run : storage_.divergence.runs)
      if (run.stencil == no_stencil) general += run.count;
    if (general > most_stencils_) return std::nullopt;
    for (const RowRun& run : storage_.divergence.runs)
      for (Index q = run.first; q < run.first + run.count;) {
        const Index count = read_signature(run, q);
        const auto [entry, fresh] = numbers_.try_emplace(signature_, result_.rows.stencils());
        if (fresh && (result_.rows.stencils() >= most_stencils_ || !add_stencil(run, q)))
          return std::nullopt;
        add_rows(q, count, entry->second);
        q += count;
      }
    for (const RowRun& run : result_.rows.runs) {
      const auto s = static_cast<std::size_t>(run.stencil);
      const int entries = result_.rows.stencil_start[s + 1] - result_.rows.stencil_start[s];
      const auto rows = static_cast<double>(run.count * D);
      result_.multiply_adds += rows * (entries + result_.mixed[s]);
      // A difference of a place that is loaded, and the acceleration to its window and back.
      result_.work += rows * (3.0 * entries + result_.mixed[s] + 3.0);
    }
    result_.multiply_adds /= static_cast<double>(storage_.inverse_mass.size());
    result_.work /= static_cast<double>(storage_.inverse_mass.size());
    run_on();
    return std::move(result_);
  }

 private:
  using Block = Tensor<D>;

  /// What makes the block row of a node of a run: the stencils of all rows that it is composed of
  /// with their columns from the node, and rows without a stencil by their own numbers, which are
  /// below −1. Returns how many nodes from there on have the same.
  Index read_signature(const RowRun& run, Index q) {
    signature_.clear();
    Index count = run.count - (q - run.first);
    const auto add = [&](const RowRun& part, Index row) {
      if (part.stencil == no_stencil) {
        count = 1;
        signature_.push_back(-2 - static_cast<int>(row));
        return;
      }
      count = std::min(count, part.first + part.count - row);
      signature_.push_back(part.stencil);
    };
    const auto column = [&](const RowRun& part, Index row) {
      signature_.push_back(static_cast<int>(part.column + (row - part.first) - q));
    };
    add(run, q);
    const Row<double> points = row_of(storage_.divergence, storage_.tables.divergence, run, q);
    for (Index k = 0; k < points.entries; ++k) {
      const Index s = points.origin + points.index[k];
      const RowRun& part = run_of(storage_.gradient.runs, s);
      add(part, s);
      column(part, s);
      if (!regions_.empty()) add(run_of(regions_, s), s);
    }
    if (storage_.tables.has_rows) {
      const RowRun& part = run_of(storage_.rows.runs, q);
      add(part, q);
      column(part, q);
    }
    return count;
  }

  /// Adds d P over the nodes that one point reads.
  void add_point(const double* d, double scale, Index s, Index q) {
    const Row<double> nodes =
        row_of(storage_.gradient, storage_.tables.gradient, run_of(storage_.gradient.runs, s), s);
    const Tangent<D>& A =
        tangents_[regions_.empty() ? 0 : static_cast<std::size_t>(run_of(regions_, s).stencil)];
    for (Index k = 0; k < nodes.entries; ++k) {
      const double* g = nodes.weight + k * storage_.gradient.stride;
      Block& block =
          blocks_.try_emplace(nodes.origin + nodes.index[k] - q, Block::Zero()).first->second;
      const double hourglass = storage_.tables.modes ? d[D] * g[D] : 0.0;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
          double sum = i == j ? hourglass : 0.0;
          for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b) sum += d[a] * A(i * D + a, j * D + b) * g[b];
          block(i, j) += scale * sum;
        }
    }
  }

  /// The block row of node q as a stencil; false where it sees a translation.
  bool add_stencil(const RowRun& run, Index q) {
    constexpr double rounding = 1e-14, nothing = 1e-14;  // of the largest
    blocks_.clear();
    const Row<double> points = row_of(storage_.divergence, storage_.tables.divergence, run, q);
    for (Index k = 0; k < points.entries; ++k)
      add_point(points.weight + k * storage_.divergence.stride, points.scale,
                points.origin + points.index[k], q);
    Block sum = Block::Zero();
    double largest = 0.0;
    for (const auto& [at, block] : blocks_) {
      sum += block;
      largest = std::max(largest, block.cwiseAbs().maxCoeff());
    }
    if (!(sum.cwiseAbs().maxCoeff() <= rounding * largest)) return false;
    add_pairs(q);
    blocks_.erase(0);
    const auto mixes = [&](const Block& block) {
      return D == 2 &&
             std::max(std::abs(block(0, D - 1)), std::abs(block(D - 1, 0))) > nothing * largest;
    };
    int reach = 0;
    const auto add_entry = [&](Index at, const Block& block) {
      RowStorage& rows = result_.rows;
      rows.offset.push_back(static_cast<int>(at));
      reach = std::max(reach, rows.offset.back());
      for (int i = 0; i < D; ++i) rows.weight.push_back(block(i, i));
      // What a component gives to the other one.
      if (D == 2) rows.weight.insert(rows.weight.end(), {block(D - 1, 0), block(0, D - 1)});
    };
    for (const auto& [at, block] : blocks_)
      if (mixes(block)) add_entry(at, block);
    result_.mixed.push_back(static_cast<int>(result_.rows.offset.size()) -
                            result_.rows.stencil_start.back());
    for (const auto& [at, block] : blocks_)
      if (!mixes(block) && block.cwiseAbs().maxCoeff() > nothing * largest)
        add_entry(at, block.diagonal().asDiagonal());
    result_.rows.reach.push_back(reach);
    result_.rows.stencil_start.push_back(static_cast<int>(result_.rows.offset.size()));
    return true;
  }

  void add_pairs(Index q) {
    if (!storage_.tables.has_rows) return;
    const Row<double> row =
        row_of(storage_.rows, storage_.tables.rows, run_of(storage_.rows.runs, q), q);
    for (Index k = 0; k < row.entries; ++k)
      blocks_.try_emplace(row.origin + row.index[k] - q, Block::Zero()).first->second -=
          row.scale * row.weight[k] * Block::Identity();
  }

  void add_rows(Index first, Index count, int stencil) {
    std::vector<RowRun>& runs = result_.rows.runs;
    const int row = static_cast<int>(first);
    if (runs.empty() || runs.back().stencil != stencil) runs.push_back({row, 0, row, stencil});
    runs.back().count += static_cast<int>(count);
  }

  /// Joins runs of one stencil with few rows between them: a long run costs less than several, the
  /// rows between, computed in vain, included.
  void run_on() {
    constexpr int most_between = 4;
    const std::vector<RowRun> runs = std::move(result_.rows.runs);
    std::vector<RowRun>& joined = result_.rows.runs = {};
    for (std::size_t k = 0; k < runs.size();) {
      RowRun run = runs[k++];
      for (std::size_t next = k; next < runs.size();) {
        const int between = runs[next].first - (run.first + run.count);
        if (between > most_between) break;
        if (runs[next].stencil != run.stencil || runs[next].count < between) {
          ++next;
          continue;
        }
        result_.patches.insert(result_.patches.end(), runs.begin() + static_cast<Index>(k),
                               runs.begin() + static_cast<Index>(next));
        run.count = runs[next].first + runs[next].count - run.first;
        k = ++next;
      }
      joined.push_back(run);
    }
  }

  const Storage<D>& storage_;
  std::vector<Tangent<D>> tangents_;  // of the regions
  Index most_stencils_;
  std::vector<RowRun> regions_;  // of points, by `stencil`; empty if there is one
  std::vector<int> signature_;
  std::map<std::vector<int>, int> numbers_;
  std::map<Index, Block> blocks_;  // of the row in the making, by offset
  Stiffness<D> result_;
};

}  // namespace

template <int D>
std::optional<Stiffness<D>> stiffness_of(const Discretisation<D>& body, const Storage<D>& storage,
                                         const std::vector<RegionLaw<D>>& laws,
                                         Index most_stencils) {
  const bool single = storage.tables.gradient.weight_single != nullptr ||
                      storage.tables.divergence.weight_single != nullptr;
  const bool known =
      std::ranges::all_of(laws, [](const auto& law) { return law.loops != nullptr; });
  if (!known || !body.linear() || storage.tables.viscous || single || body.nodes() == 0)
    return std::nullopt;
  return Composer<D>(body, storage, laws, most_stencils).compose();
}

template <int D>
RowWeights Stiffness<D>::table() const {
  RowWeights table;
  set_stencils(table, rows);
  table.mixed = mixed.data();
  return table;
}

template <int D>
double Stiffness<D>::bytes() const {
  return static_cast<double>((rows.runs.size() + patches.size()) * sizeof(RowRun) +
                             rows.offset.size() * sizeof(int) +
                             rows.weight.size() * sizeof(double));
}

template <int D>
PlanInput Stiffness<D>::plan_input(const std::vector<RowRun>& nodes) const {
  PlanInput input;
  input.nodes = &nodes;
  StreamRows& stream = input.rows;
  stream.count = rows.runs.empty() ? 0 : rows.runs.back().first + rows.runs.back().count;
  stream.runs = &rows.runs;
  stream.patches = &patches;
  const auto n = static_cast<std::size_t>(stream.count);
  stream.low.assign(n, static_cast<int>(n));
  stream.high.assign(n, 0);
  stream.readers.assign(n, -1);
  const auto at_least = [](int& value, int other) { value = std::max(value, other); };
  for (const auto* list : {&rows.runs, &patches})
    for (const RowRun& run : *list) {
      const auto s = static_cast<std::size_t>(run.stencil);
      const auto first = rows.offset.begin() + rows.stencil_start[s];
      const auto last = rows.offset.begin() + rows.stencil_start[s + 1];
      const int low = first == last ? 0 : std::min(0, *std::min_element(first, last));
      for (int q = run.first; q < run.first + run.count; ++q) {
        const auto row = static_cast<std::size_t>(q);
        stream.low[row] = std::min(stream.low[row], q + low);
        at_least(stream.high[row], q + rows.reach[s]);
        at_least(stream.readers[row], q);
        for (auto at = first; at != last; ++at)
          at_least(stream.readers[static_cast<std::size_t>(Index{q} + *at)], q);
      }
    }
  return input;
}

template <int D>
double work_of_points(const Discretisation<D>& body) {
  constexpr double law = D == 1 ? 1.0 : 6.0;
  const double directions = body.hourglass.empty() ? D : D + 1;
  const auto gradient = static_cast<double>(body.gradient.nonzeros());
  const auto divergence = static_cast<double>(body.divergence.nonzeros());
  const auto points = static_cast<double>(body.points.size());
  const auto pairs = static_cast<double>(body.stiffness.nonZeros());
  const double rows = pairs > 0.0 ? 3.0 * static_cast<double>(body.nodes()) : 0.0;
  return (gradient * (1.0 + directions) * D + points * (directions * D + law) +
          divergence * 2.0 * directions * D + (3.0 * pairs + rows) * D) /
         static_cast<double>(body.nodes());
}

#define TLSPH_INSTANTIATE(D)                                                                     \
  template struct Stiffness<D>;                                                                  \
  template double work_of_points<D>(const Discretisation<D>&);                                   \
  template std::optional<Stiffness<D>> stiffness_of(const Discretisation<D>&, const Storage<D>&, \
                                                    const std::vector<RegionLaw<D>>&, Index);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph::sweep

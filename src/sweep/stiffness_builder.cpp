#include "stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tlsph::sweep {
namespace {

/// The run with that row in it; runs are ascending and leave no row out.
const RowRun& run_of(const std::vector<RowRun>& runs, Index row) {
  return *(std::ranges::upper_bound(runs, row, {}, [](const RowRun& run) { return run.first; }) -
           1);
}

/// A row wherever it is stored; entry k stands at column origin + index[k].
struct StoredRow {
  const int* index;
  const double* weight;
  Index entries;
  Index origin;
  double scale;
};

StoredRow row_of(const RowStorage& rows, const RowWeights& table, const RowRun& run, Index row) {
  if (run.stencil == no_stencil) {
    const Index start = table.row_start[row];
    return {table.column + start, table.weight + start * rows.stride,
            table.row_start[row + 1] - start, 0,
            table.row_scale != nullptr ? table.row_scale[row] : 1.0};
  }
  const Index start = table.stencil_start[run.stencil];
  return {table.offset + start, table.stencil_weight + start * rows.stride,
          table.stencil_start[run.stencil + 1] - start, run.column + (row - run.first), 1.0};
}

Index general_rows(const RowStorage& rows) {
  Index count = 0;
  for (const RowRun& run : rows.runs)
    if (run.stencil == no_stencil) count += run.count;
  return count;
}

template <int D>
class Composer {
 public:
  Composer(const Discretisation<D>& disc, const Storage<D>& storage,
           const std::vector<RegionLaw<D>>& laws, Index most_stencils)
      : storage_(storage), nodes_(disc.nodes()), most_stencils_(most_stencils) {
    for (const RegionLaw<D>& law : laws)
      tangents_.push_back(tangent<D>(law.law, Tensor<D>::Zero()));
    const std::vector<int> regions = regions_of_points(disc);
    for (std::size_t s = 0; s < regions.size(); ++s)
      if (s > 0 && regions[s] == regions_.back().stencil)
        ++regions_.back().count;
      else
        regions_.push_back({static_cast<int>(s), 1, 0, regions[s]});
  }

  std::optional<Stiffness<D>> compose() {
    if (general_rows(storage_.divergence) > most_stencils_) return std::nullopt;
    for (const RowRun& run : storage_.divergence.runs)
      for (Index q = run.first; q < run.first + run.count;) {
        const Index count = read_signature(run, q);
        const auto [entry, fresh] = numbers_.try_emplace(signature_, result_.stencils());
        if (fresh && (result_.stencils() >= most_stencils_ || !add_stencil(run, q)))
          return std::nullopt;
        add_rows(q, count, entry->second);
        q += count;
      }
    for (const RowRun& run : result_.runs) {
      const auto s = static_cast<std::size_t>(run.stencil);
      const int entries = result_.stencil_start[s + 1] - result_.stencil_start[s];
      const auto rows = static_cast<double>(run.count * D);
      result_.multiply_adds += rows * (entries + result_.mixed[s]);
      // A difference of a place that is loaded, and the acceleration to its window and back.
      result_.work += rows * (3.0 * entries + result_.mixed[s] + 3.0);
    }
    result_.multiply_adds /= static_cast<double>(nodes_);
    result_.work /= static_cast<double>(nodes_);
    result_.run_on();
    return std::move(result_);
  }

 private:
  using Block = Tensor<D>;

  /// What makes the block row of a node of a run; how many nodes from there on have the same.
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
    const StoredRow points = row_of(storage_.divergence, storage_.divergence_table, run, q);
    for (Index k = 0; k < points.entries; ++k) {
      const Index s = points.origin + points.index[k];
      const RowRun& part = run_of(storage_.gradient.runs, s);
      add(part, s);
      column(part, s);
      if (!regions_.empty()) add(run_of(regions_, s), s);
    }
    if (storage_.has_rows) {
      const RowRun& part = run_of(storage_.rows.runs, q);
      add(part, q);
      column(part, q);
    }
    return count;
  }

  /// Adds d P over the nodes that one point reads.
  void add_point(const double* d, double scale, Index s, Index q) {
    const StoredRow nodes =
        row_of(storage_.gradient, storage_.gradient_table, run_of(storage_.gradient.runs, s), s);
    const Tangent<D>& A =
        tangents_[regions_.empty() ? 0 : static_cast<std::size_t>(run_of(regions_, s).stencil)];
    for (Index k = 0; k < nodes.entries; ++k) {
      const double* g = nodes.weight + k * storage_.gradient.stride;
      Block& block =
          blocks_.try_emplace(nodes.origin + nodes.index[k] - q, Block::Zero()).first->second;
      const double hourglass = storage_.modes ? d[D] * g[D] : 0.0;
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
    const StoredRow points = row_of(storage_.divergence, storage_.divergence_table, run, q);
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
    int mixed = 0;
    for (const auto& [at, block] : blocks_)
      if (mixes(block)) {
        add_entry(at, block);
        ++mixed;
      }
    for (const auto& [at, block] : blocks_)
      if (!mixes(block) && block.cwiseAbs().maxCoeff() > nothing * largest) {
        add_entry(at, block.diagonal().asDiagonal());
      }
    result_.mixed.push_back(mixed);
    const auto first = result_.offset.begin() + result_.stencil_start.back();
    result_.reach.push_back(first == result_.offset.end()
                                ? 0
                                : std::max(0, *std::max_element(first, result_.offset.end())));
    result_.stencil_start.push_back(static_cast<int>(result_.offset.size()));
    return true;
  }

  void add_pairs(Index q) {
    if (!storage_.has_rows) return;
    const StoredRow row =
        row_of(storage_.rows, storage_.rows_table, run_of(storage_.rows.runs, q), q);
    for (Index k = 0; k < row.entries; ++k)
      blocks_.try_emplace(row.origin + row.index[k] - q, Block::Zero()).first->second -=
          row.scale * row.weight[k] * Block::Identity();
  }

  void add_entry(Index at, const Block& block) {
    result_.offset.push_back(static_cast<int>(at));
    for (int i = 0; i < D; ++i) result_.weight.push_back(block(i, i));
    // What a component gives to the other one.
    if (D == 2) result_.weight.insert(result_.weight.end(), {block(D - 1, 0), block(0, D - 1)});
  }

  void add_rows(Index first, Index count, int stencil) {
    if (!result_.runs.empty() && result_.runs.back().stencil == stencil) {
      result_.runs.back().count += static_cast<int>(count);
      return;
    }
    const int row = static_cast<int>(first);
    result_.runs.push_back({row, static_cast<int>(count), row, stencil});
  }

  const Storage<D>& storage_;
  std::vector<Tangent<D>> tangents_;  // of the regions
  Index nodes_;
  Index most_stencils_;
  std::vector<RowRun> regions_;  // of points, by `stencil`; empty if there is one
  std::vector<int> signature_;
  std::map<std::vector<int>, int> numbers_;
  std::map<Index, Block> blocks_;  // of the row in the making, by offset
  Stiffness<D> result_;
};

}  // namespace

template <int D>
std::optional<Stiffness<D>> stiffness_of(const Discretisation<D>& disc, const Storage<D>& storage,
                                         const std::vector<RegionLaw<D>>& laws,
                                         Index most_stencils) {
  const bool single = storage.gradient_table.weight_single != nullptr ||
                      storage.divergence_table.weight_single != nullptr;
  const bool known =
      std::ranges::all_of(laws, [](const auto& law) { return law.loops != nullptr; });
  if (!known || !disc.linear() || storage.viscous || single || disc.nodes() == 0)
    return std::nullopt;
  return Composer<D>(disc, storage, laws, most_stencils).compose();
}

template std::optional<Stiffness<1>> stiffness_of(const Discretisation<1>&, const Storage<1>&,
                                                  const std::vector<RegionLaw<1>>&, Index);
template std::optional<Stiffness<2>> stiffness_of(const Discretisation<2>&, const Storage<2>&,
                                                  const std::vector<RegionLaw<2>>&, Index);

}  // namespace tlsph::sweep

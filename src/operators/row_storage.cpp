#include "tlsph/operators/row_storage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace tlsph {
namespace {

constexpr std::size_t most_candidates = 64;  // stencils of one pattern that a row is compared with
constexpr Index fewest_rows = 4;             // that make a stencil worth its name

/// A row of the pattern with its weights.
struct Row {
  const int* column;
  const double* weight;
  const double* further;  // nullptr: none
  int entries;
};

class StencilFinder {
 public:
  StencilFinder(int stride, double tolerance) : stride_(stride), tolerance_(tolerance) {}

  /// Number of the stencil the row belongs to, a new one if need be; `no_stencil` where its pattern
  /// has too many already.
  int find(const Row& row) {
    if (row.entries == 0) return no_stencil;
    if (last_ != no_stencil && matches(last_, row)) return last_;
    std::vector<int>& candidates = by_pattern_[hash(row)];
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (matches(candidates[k], row)) {
        last_ = candidates[k];
        std::rotate(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(k),
                    candidates.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        return last_;
      }
    if (candidates.size() >= most_candidates) return no_stencil;
    candidates.insert(candidates.begin(), static_cast<int>(example_.size()));
    last_ = candidates.front();
    double largest = 0.0;
    for (int k = 0; k < row.entries * stride_; ++k)
      largest = std::max(largest, std::abs(row.weight[k]));
    for (int k = 0; row.further != nullptr && k < row.entries; ++k)
      largest = std::max(largest, std::abs(row.further[k]));
    example_.push_back(row);
    allowed_.push_back(tolerance_ * largest);
    return last_;
  }

  [[nodiscard]] const std::vector<Row>& examples() const { return example_; }

 private:
  [[nodiscard]] bool matches(int stencil, const Row& row) const {
    const Row& example = example_[static_cast<std::size_t>(stencil)];
    if (example.entries != row.entries) return false;
    for (int k = 0; k < row.entries; ++k)
      if (example.column[k] - example.column[0] != row.column[k] - row.column[0]) return false;
    const double allowed = allowed_[static_cast<std::size_t>(stencil)];
    for (int k = 0; k < row.entries * stride_; ++k)
      if (!(std::abs(example.weight[k] - row.weight[k]) <= allowed)) return false;
    for (int k = 0; row.further != nullptr && k < row.entries; ++k)
      if (!(std::abs(example.further[k] - row.further[k]) <= allowed)) return false;
    return true;
  }

  static std::size_t hash(const Row& row) {
    auto value = static_cast<std::size_t>(row.entries);
    for (int k = 1; k < row.entries; ++k)
      value =
          (value ^ static_cast<std::size_t>(row.column[k] - row.column[0])) * 0x9E3779B97F4A7C15u;
    return value;
  }

  int stride_;
  double tolerance_;
  int last_ = no_stencil;
  std::vector<Row> example_;
  std::vector<double> allowed_;
  std::unordered_map<std::size_t, std::vector<int>> by_pattern_;
};

}  // namespace

RowStorage share_rows(const Neighbours& pattern, std::span<const double> weights, int stride,
                      double tolerance, std::span<const double> further) {
  const auto row_at = [&](Index r) {
    const Index start = pattern.start[static_cast<std::size_t>(r)];
    const Index end = pattern.start[static_cast<std::size_t>(r) + 1];
    return Row{pattern.column.data() + start, weights.data() + start * stride,
               further.empty() ? nullptr : further.data() + start, static_cast<int>(end - start)};
  };
  StencilFinder finder(stride, tolerance);
  std::vector<int> stencil(static_cast<std::size_t>(pattern.rows()));
  for (Index r = 0; r < pattern.rows(); ++r)
    stencil[static_cast<std::size_t>(r)] = finder.find(row_at(r));

  std::vector<Index> uses(finder.examples().size(), 0);
  for (const int s : stencil)
    if (s != no_stencil) ++uses[static_cast<std::size_t>(s)];
  RowStorage storage;
  storage.stride = further.empty() ? stride : stride + 1;
  storage.stencil_start = {0};
  std::vector<int> number(uses.size(), no_stencil);
  for (std::size_t s = 0; s < uses.size(); ++s) {
    if (uses[s] < fewest_rows) continue;
    number[s] = storage.stencils();
    const Row& row = finder.examples()[s];
    for (int k = 0; k < row.entries; ++k) {
      storage.offset.push_back(row.column[k] - row.column[0]);
      storage.weight.insert(storage.weight.end(), row.weight + k * stride,
                            row.weight + (k + 1) * stride);
      if (row.further != nullptr) storage.weight.push_back(row.further[k]);
    }
    storage.stencil_start.push_back(static_cast<int>(storage.offset.size()));
    storage.reach.push_back(row.column[row.entries - 1] - row.column[0]);
  }

  for (Index r = 0; r < pattern.rows(); ++r) {
    const int found = stencil[static_cast<std::size_t>(r)];
    const int s = found == no_stencil ? no_stencil : number[static_cast<std::size_t>(found)];
    const int column = s == no_stencil ? 0 : row_at(r).column[0];
    if (!storage.runs.empty()) {
      RowRun& run = storage.runs.back();
      if (run.stencil == s && (s == no_stencil || column == run.column + run.count)) {
        ++run.count;
        continue;
      }
    }
    storage.runs.push_back({static_cast<int>(r), 1, column, s});
  }
  return storage;
}

Index append_runs(const std::vector<RowRun>& runs, Index first, Index last,
                  std::vector<RowRun>& to) {
  const auto start = static_cast<Index>(to.size());
  auto run = std::upper_bound(runs.begin(), runs.end(), first,
                              [](Index row, const RowRun& r) { return row < r.first; });
  if (run != runs.begin()) --run;
  for (; run != runs.end() && run->first < last; ++run) {
    const Index from = std::max<Index>(run->first, first);
    const Index end = std::min<Index>(run->first + run->count, last);
    if (from >= end) continue;
    RowRun part = *run;
    part.first = static_cast<int>(from);
    part.count = static_cast<int>(end - from);
    if (run->stencil != no_stencil) part.column += static_cast<int>(from) - run->first;
    to.push_back(part);
  }
  return start;
}

void write_shared(const RowStorage& storage, const Neighbours& pattern, std::span<double> weights) {
  for (const RowRun& run : storage.runs) {
    if (run.stencil == no_stencil) continue;
    const auto s = static_cast<std::size_t>(run.stencil);
    const auto first = storage.weight.begin() + Index{storage.stencil_start[s]} * storage.stride;
    const auto last = storage.weight.begin() + Index{storage.stencil_start[s + 1]} * storage.stride;
    for (int r = run.first; r < run.first + run.count; ++r)
      std::copy(first, last,
                weights.begin() + pattern.start[static_cast<std::size_t>(r)] * storage.stride);
  }
}

StorageReport report(const RowStorage& storage, const Neighbours& pattern) {
  StorageReport result;
  result.distinct_stencils = storage.stencils();
  const auto stride = static_cast<double>(storage.stride);
  for (const RowRun& run : storage.runs) {
    if (run.stencil != no_stencil) {
      result.stencil_rows += run.count;
      continue;
    }
    result.general_rows += run.count;
    const Index entries =
        pattern.start[static_cast<std::size_t>(run.first) + static_cast<std::size_t>(run.count)] -
        pattern.start[static_cast<std::size_t>(run.first)];
    result.bytes += static_cast<double>(entries) * (sizeof(int) + stride * sizeof(double)) +
                    run.count * static_cast<double>(sizeof(Index));
  }
  result.bytes += static_cast<double>(storage.runs.size() * sizeof(RowRun)) +
                  static_cast<double>(storage.offset.size() * sizeof(int)) +
                  static_cast<double>(storage.weight.size() * sizeof(double));
  return result;
}

double shared_row_tolerance(double reach, double spacing) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  return std::max(1e-11, 4.0 * rounding * reach / spacing);
}

ScalarField with_shared_values(ScalarField values, double tolerance) {
  constexpr std::size_t most_values = 16;
  std::vector<double> seen;
  for (double& value : values) {
    const auto same = std::ranges::find_if(
        seen, [&](double other) { return std::abs(other - value) <= tolerance * std::abs(other); });
    if (same != seen.end()) {
      value = *same;
      std::rotate(seen.begin(), same, same + 1);
    } else {
      if (seen.size() == most_values) seen.pop_back();
      seen.insert(seen.begin(), value);
    }
  }
  return values;
}

}  // namespace tlsph

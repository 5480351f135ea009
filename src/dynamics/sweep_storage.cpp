#include "sweep_storage.hpp"

#include <algorithm>
#include <map>

#include "tlsph/operators/stabilisers.hpp"

namespace tlsph::sweep {
namespace {

/// diag(scale) times the rows: runs end where the factor changes.
RowStorage with_row_factors(const RowStorage& rows, const ScalarField& scale) {
  RowStorage result;
  result.stride = rows.stride;
  result.stencil_start = {0};
  std::map<std::pair<int, double>, int> numbers;
  const auto scaled = [&](int stencil, double factor) {
    const auto [entry, fresh] = numbers.try_emplace({stencil, factor}, result.stencils());
    if (!fresh) return entry->second;
    const auto s = static_cast<std::size_t>(stencil);
    for (int k = rows.stencil_start[s]; k < rows.stencil_start[s + 1]; ++k) {
      result.offset.push_back(rows.offset[static_cast<std::size_t>(k)]);
      for (int a = 0; a < rows.stride; ++a)
        result.weight.push_back(factor *
                                rows.weight[static_cast<std::size_t>(k * rows.stride + a)]);
    }
    result.stencil_start.push_back(static_cast<int>(result.offset.size()));
    result.reach.push_back(rows.reach[s]);
    return entry->second;
  };
  for (const RowRun& run : rows.runs) {
    if (run.stencil == no_stencil) {
      result.runs.push_back(run);
      continue;
    }
    for (int r = 0; r < run.count;) {
      const double factor = scale[run.first + r];
      int end = r + 1;
      while (end < run.count && scale[run.first + end] == factor) ++end;
      result.runs.push_back({run.first + r, end - r, run.column + r, scaled(run.stencil, factor)});
      r = end;
    }
  }
  return result;
}

void set_stencils(Table& table, const RowStorage& rows) {
  table.stencil_start = rows.stencil_start.data();
  table.offset = rows.offset.data();
  table.stencil_weight = rows.weight.data();
  table.reach = rows.reach.data();
}

void set_general(Table& table, const Neighbours& pattern, const double* weights) {
  table.row_start = pattern.start.data();
  table.column = pattern.column.data();
  table.weight = weights;
}

/// The weights of an operator with rows that have no stencil; empty if there are none.
std::vector<float> singles(const RowStorage& rows, std::span<const double> weights) {
  const bool general =
      std::ranges::any_of(rows.runs, [](const RowRun& run) { return run.stencil == no_stencil; });
  if (!general) return {};
  std::vector<float> result(weights.size());
  std::ranges::transform(weights, result.begin(), [](double w) { return static_cast<float>(w); });
  return result;
}

/// First and last column of every row, −1 for rows without any.
void column_range(const Neighbours& pattern, std::vector<int>& low, std::vector<int>& high) {
  const auto rows = static_cast<std::size_t>(pattern.rows());
  low.assign(rows, 0);
  high.assign(rows, -1);
  for (std::size_t r = 0; r < rows; ++r) {
    if (pattern.start[r] == pattern.start[r + 1]) continue;
    low[r] = pattern.column[static_cast<std::size_t>(pattern.start[r])];
    high[r] = pattern.column[static_cast<std::size_t>(pattern.start[r + 1]) - 1];
  }
}

/// The last row that has an entry in each column.
std::vector<int> last_reader(const Neighbours& pattern, Index columns) {
  std::vector<int> last(static_cast<std::size_t>(columns), -1);
  for (Index r = 0; r < pattern.rows(); ++r)
    for (Index k = pattern.start[static_cast<std::size_t>(r)];
         k < pattern.start[static_cast<std::size_t>(r) + 1]; ++k)
      last[static_cast<std::size_t>(pattern.column[static_cast<std::size_t>(k)])] =
          static_cast<int>(r);
  return last;
}

Neighbours pattern_of(const SparseMatrix& matrix) {
  Neighbours pattern;
  pattern.start.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows() + 1);
  pattern.column.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
  return pattern;
}

/// The weights of an operator with a direction more, entry by entry.
std::vector<double> with_direction(std::span<const double> weights, int stride,
                                   const double* further) {
  const std::size_t entries = weights.size() / static_cast<std::size_t>(stride);
  std::vector<double> result;
  result.reserve(entries * static_cast<std::size_t>(stride + 1));
  for (std::size_t k = 0; k < entries; ++k) {
    const auto from = weights.begin() + static_cast<std::ptrdiff_t>(k) * stride;
    result.insert(result.end(), from, from + stride);
    result.push_back(further[k]);
  }
  return result;
}

bool same_pattern(const Neighbours& pattern, const SparseMatrix& matrix) {
  return std::equal(pattern.column.begin(), pattern.column.end(), matrix.innerIndexPtr(),
                    matrix.innerIndexPtr() + matrix.nonZeros()) &&
         std::equal(pattern.start.begin(), pattern.start.end(), matrix.outerIndexPtr(),
                    matrix.outerIndexPtr() + matrix.rows() + 1);
}

}  // namespace

template <int D>
Storage<D>::Storage(const Discretisation<D>& disc, bool single)
    : inverse_mass(disc.mass.cwiseInverse()), disc_(disc) {
  const Neighbours& gradient_pattern = disc.gradient.pattern();
  const Neighbours& divergence_pattern = disc.divergence.pattern();
  add_modes();
  const std::span<const double> g =
      modes ? std::span<const double>(gradient_weights_) : disc.gradient.weights();
  const std::span<const double> d =
      modes ? std::span<const double>(divergence_weights_) : disc.divergence.weights();
  const int directions = modes ? D + 1 : D;
  gradient = share_rows(gradient_pattern, g, directions);
  divergence = with_row_factors(share_rows(divergence_pattern, d, directions), inverse_mass);
  set_stencils(gradient_table, gradient);
  set_stencils(divergence_table, divergence);
  set_general(gradient_table, gradient_pattern, g.data());
  set_general(divergence_table, divergence_pattern, d.data());
  divergence_table.row_scale = inverse_mass.data();
  if (single) {
    gradient_single_ = singles(gradient, g);
    divergence_single_ = singles(divergence, d);
    gradient_table.weight_single = gradient_single_.empty() ? nullptr : gradient_single_.data();
    divergence_table.weight_single =
        divergence_single_.empty() ? nullptr : divergence_single_.data();
  }
  report = tlsph::report(gradient, gradient_pattern);
  add(tlsph::report(divergence, divergence_pattern));
  add_rows();
  release_unused();
}

template <int D>
void Storage<D>::add_rows() {
  const SparseMatrix* matrix = nullptr;
  if (disc_.viscosity.nonZeros() > 0)
    matrix = &disc_.viscosity;
  else if (disc_.stiffness.nonZeros() > 0 && !modes)
    matrix = &disc_.stiffness;
  if (matrix == nullptr) return;
  has_rows = true;
  viscous = matrix == &disc_.viscosity;
  rows_pattern_ = pattern_of(*matrix);
  const std::span<const double> values(matrix->valuePtr(),
                                       static_cast<std::size_t>(matrix->nonZeros()));
  rows = with_row_factors(share_rows(rows_pattern_, values, 1), inverse_mass);
  set_stencils(rows_table, rows);
  set_general(rows_table, rows_pattern_, values.data());
  rows_table.row_scale = inverse_mass.data();
  add(tlsph::report(rows, rows_pattern_));
}

template <int D>
void Storage<D>::add(const StorageReport& other) {
  report.stencil_rows += other.stencil_rows;
  report.distinct_stencils += other.distinct_stencils;
  report.general_rows += other.general_rows;
  report.bytes += other.bytes;
}

/// Copies that only general rows would read.
template <int D>
void Storage<D>::release_unused() {
  const auto all_stencils = [](const RowStorage& storage) {
    return std::ranges::all_of(storage.runs,
                               [](const RowRun& run) { return run.stencil != no_stencil; });
  };
  if (all_stencils(gradient)) gradient_weights_ = {};
  if (all_stencils(divergence)) divergence_weights_ = {};
}

/// The cell stabiliser S = Aᵀ κ A as a direction more: A u beside G u, −Aᵀ κ beside D.
template <int D>
void Storage<D>::add_modes() {
  if constexpr (D == 2) {
    if (disc_.cell_modulus.size() == 0) return;
    const SparseMatrix A = hourglass_rows(disc_.particles, disc_.gradient);
    if (!same_pattern(disc_.gradient.pattern(), A)) return;
    const SparseMatrix force = SparseMatrix(-(disc_.cell_modulus.asDiagonal() * A)).transpose();
    if (!same_pattern(disc_.divergence.pattern(), force)) return;
    gradient_weights_ = with_direction(disc_.gradient.weights(), D, A.valuePtr());
    divergence_weights_ = with_direction(disc_.divergence.weights(), D, force.valuePtr());
    modes = true;
  }
}

template <int D>
Dependences Storage<D>::dependences() const {
  Dependences dep;
  dep.points = disc_.points.size();
  dep.nodes = disc_.nodes();
  column_range(disc_.gradient.pattern(), dep.gradient_low, dep.gradient_high);
  column_range(disc_.divergence.pattern(), dep.divergence_low, dep.divergence_high);
  dep.point_readers = last_reader(disc_.gradient.pattern(), disc_.nodes());
  if (has_rows) {
    column_range(rows_pattern_, dep.rows_low, dep.rows_high);
    dep.row_readers = last_reader(rows_pattern_, disc_.nodes());
  }
  return dep;
}

template class Storage<1>;
template class Storage<2>;

}  // namespace tlsph::sweep

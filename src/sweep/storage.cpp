#include "storage.hpp"

#include <algorithm>
#include <cassert>
#include <map>

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
                                rows.weight[static_cast<std::size_t>(Index{k} * rows.stride + a)]);
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

void set_stencils(RowWeights& table, const RowStorage& rows) {
  table.stencil_start = rows.stencil_start.data();
  table.offset = rows.offset.data();
  table.stencil_weight = rows.weight.data();
  table.reach = rows.reach.data();
}

void set_general(RowWeights& table, const Neighbours& pattern, const double* weights) {
  table.row_start = pattern.start.data();
  table.column = pattern.column.data();
  table.weight = weights;
}

/// The weights of rows without a stencil, at the places where those of all rows would stand, with a
/// direction more if there are modes. The places of other rows are asked for and never touched, so
/// that they take no page of memory.
template <class Real, int D>
std::unique_ptr<Real[]> weights_of_general(const RowStorage& rows, const VectorOperator<D>& op,
                                           std::span<const double> modes) {
  const std::size_t stride = modes.empty() ? D : D + 1;
  auto result =
      std::make_unique_for_overwrite<Real[]>(static_cast<std::size_t>(op.nonzeros()) * stride);
  for (const RowRun& run : rows.runs) {
    if (run.stencil != no_stencil) continue;
    const auto first = static_cast<std::size_t>(run.first);
    const auto begin = static_cast<std::size_t>(op.pattern().start[first]);
    const auto end =
        static_cast<std::size_t>(op.pattern().start[first + static_cast<std::size_t>(run.count)]);
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t a = 0; a < D; ++a)
        result[k * stride + a] = static_cast<Real>(op.weights()[k * D + a]);
      if (!modes.empty()) result[k * stride + D] = static_cast<Real>(modes[k]);
    }
  }
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

}  // namespace

template <int D>
Storage<D>::Storage(const Discretisation<D>& disc, bool single)
    : modes(!disc.hourglass.empty()), inverse_mass(disc.mass.cwiseInverse()), disc_(disc) {
  const Neighbours& gradient_pattern = disc.gradient.pattern();
  const Neighbours& divergence_pattern = disc.divergence.pattern();
  const std::span<const double> amplitudes(disc.hourglass.weights);
  gradient = share_rows(gradient_pattern, disc.gradient.weights(), D, 0.0, amplitudes);
  general_gradient_ = general_rows(gradient, disc.gradient, amplitudes, single, gradient_table);
  const std::vector<double> forces = mode_forces();
  divergence = with_row_factors(
      share_rows(divergence_pattern, disc.divergence.weights(), D, 0.0, forces), inverse_mass);
  general_divergence_ = general_rows(divergence, disc.divergence, forces, single, divergence_table);
  set_stencils(gradient_table, gradient);
  set_stencils(divergence_table, divergence);
  divergence_table.row_scale = inverse_mass.data();
  report = tlsph::report(gradient, gradient_pattern);
  add(tlsph::report(divergence, divergence_pattern));
  add_rows();
}

template <int D>
auto Storage<D>::general_rows(const RowStorage& rows, const VectorOperator<D>& op,
                              std::span<const double> modes, bool single, RowWeights& table)
    -> General {
  General general;
  const bool any =
      std::ranges::any_of(rows.runs, [](const RowRun& run) { return run.stencil == no_stencil; });
  if (any && single)
    general.single = weights_of_general<float, D>(rows, op, modes);
  else if (any && !modes.empty())
    general.weight = weights_of_general<double, D>(rows, op, modes);
  set_general(table, op.pattern(), modes.empty() ? op.weights().data() : general.weight.get());
  table.weight_single = general.single.get();
  return general;
}

template <int D>
void Storage<D>::add_rows() {
  const SparseMatrix* matrix = nullptr;
  if (disc_.viscosity.nonZeros() > 0)
    matrix = &disc_.viscosity;
  else if (disc_.stiffness.nonZeros() > 0)
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

/// −Aᵀ κ, entry by entry as the weights of D: a cell stabiliser S = Aᵀ κ A is a direction more, A u
/// beside G u and −Aᵀ κ beside D.
template <int D>
std::vector<double> Storage<D>::mode_forces() const {
  if (!modes) return {};
  const Neighbours& cells = disc_.divergence.pattern();
  std::vector<double> forces(cells.column.size());
  std::vector<Index> next(cells.start.begin(), cells.start.end() - 1);
  const Neighbours& nodes = disc_.gradient.pattern();
  for (Index s = 0; s < nodes.rows(); ++s)
    for (Index k = nodes.start[static_cast<std::size_t>(s)];
         k < nodes.start[static_cast<std::size_t>(s) + 1]; ++k) {
      const auto q = static_cast<std::size_t>(nodes.column[static_cast<std::size_t>(k)]);
      const auto place = static_cast<std::size_t>(next[q]++);
      assert(cells.column[place] == s);
      forces[place] =
          -(disc_.hourglass.modulus[s] * disc_.hourglass.weights[static_cast<std::size_t>(k)]);
    }
  return forces;
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

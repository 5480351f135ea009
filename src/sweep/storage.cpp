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

/// First and last column of every row, the latter −1 for rows without any.
void column_range(const Neighbours& pattern, std::vector<int>& low, std::vector<int>& high) {
  low.assign(static_cast<std::size_t>(pattern.rows()), 0);
  high.assign(low.size(), -1);
  for (std::size_t r = 0; r < low.size(); ++r)
    if (const auto columns = pattern.of(static_cast<Index>(r)); !columns.empty()) {
      low[r] = columns.front();
      high[r] = columns.back();
    }
}

/// The rows of a pattern as a stream, as far as they read nodes.
StreamRows stream_of(const Neighbours& pattern, Index nodes, const RowStorage& rows) {
  StreamRows stream;
  stream.count = pattern.rows();
  stream.runs = &rows.runs;
  column_range(pattern, stream.low, stream.high);
  stream.readers.assign(static_cast<std::size_t>(nodes), -1);
  for (Index r = 0; r < pattern.rows(); ++r)
    for (const int q : pattern.of(r))
      stream.readers[static_cast<std::size_t>(q)] = static_cast<int>(r);
  return stream;
}

Neighbours pattern_of(const SparseMatrix& matrix) {
  Neighbours pattern;
  pattern.start.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows() + 1);
  pattern.column.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
  return pattern;
}

}  // namespace

void set_stencils(RowWeights& table, const RowStorage& rows) {
  table.stencil_start = rows.stencil_start.data();
  table.offset = rows.offset.data();
  table.stencil_weight = rows.weight.data();
  table.reach = rows.reach.data();
}

template <int D>
Storage<D>::Storage(const Discretisation<D>& body, bool single)
    : inverse_mass(body.mass.cwiseInverse()), body_(body) {
  tables.modes = !body.hourglass.empty();
  const Neighbours& gradient_pattern = body.gradient.pattern();
  const Neighbours& divergence_pattern = body.divergence.pattern();
  const std::span<const double> amplitudes(body.hourglass.weights);
  gradient = share_rows(gradient_pattern, body.gradient.weights(), D, 0.0, amplitudes);
  general_gradient_ = general_rows(gradient, body.gradient, amplitudes, single, tables.gradient);
  const std::vector<double> forces = mode_forces();
  divergence = with_row_factors(
      share_rows(divergence_pattern, body.divergence.weights(), D, 0.0, forces), inverse_mass);
  general_divergence_ =
      general_rows(divergence, body.divergence, forces, single, tables.divergence);
  set_stencils(tables.gradient, gradient);
  set_stencils(tables.divergence, divergence);
  tables.divergence.row_scale = inverse_mass.data();
  add_report(gradient, gradient_pattern);
  add_report(divergence, divergence_pattern);
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
  tables.viscous = body_.viscosity.nonZeros() > 0;
  const SparseMatrix& matrix = tables.viscous ? body_.viscosity : body_.stiffness;
  tables.has_rows = matrix.nonZeros() > 0;
  if (!tables.has_rows) return;
  rows_pattern_ = pattern_of(matrix);
  const std::span<const double> values(matrix.valuePtr(),
                                       static_cast<std::size_t>(matrix.nonZeros()));
  rows = with_row_factors(share_rows(rows_pattern_, values, 1), inverse_mass);
  set_stencils(tables.rows, rows);
  set_general(tables.rows, rows_pattern_, values.data());
  tables.rows.row_scale = inverse_mass.data();
  add_report(rows, rows_pattern_);
}

template <int D>
void Storage<D>::add_report(const RowStorage& stored, const Neighbours& pattern) {
  const StorageReport other = tlsph::report(stored, pattern);
  report.stencil_rows += other.stencil_rows;
  report.distinct_stencils += other.distinct_stencils;
  report.general_rows += other.general_rows;
  report.bytes += other.bytes;
}

/// −Aᵀ κ, entry by entry as the weights of D: a cell stabiliser S = Aᵀ κ A is a direction more, A u
/// beside G u and −Aᵀ κ beside D.
template <int D>
std::vector<double> Storage<D>::mode_forces() const {
  if (!tables.modes) return {};
  const Neighbours& cells = body_.divergence.pattern();
  std::vector<double> forces(cells.column.size());
  std::vector<Index> next(cells.start.begin(), cells.start.end() - 1);
  const Neighbours& nodes = body_.gradient.pattern();
  auto weight = body_.hourglass.weights.begin();
  for (Index s = 0; s < nodes.rows(); ++s)
    for (const int q : nodes.of(s)) {
      const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(q)]++);
      assert(cells.column[place] == s);
      forces[place] = -(body_.hourglass.modulus[s] * *weight++);
    }
  return forces;
}

template <int D>
PlanInput Storage<D>::plan_input() const {
  PlanInput input;
  input.points = stream_of(body_.gradient.pattern(), body_.nodes(), gradient);
  column_range(body_.divergence.pattern(), input.points.moving_low, input.points.moving_high);
  if (tables.has_rows) input.rows = stream_of(rows_pattern_, body_.nodes(), rows);
  input.nodes = &divergence.runs;
  return input;
}

template class Storage<1>;
template class Storage<2>;

}  // namespace tlsph::sweep

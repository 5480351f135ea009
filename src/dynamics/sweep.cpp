#include "tlsph/dynamics/sweep.hpp"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <type_traits>

#include "sweep_thread.hpp"
#include "tlsph/operators/stabilisers.hpp"

namespace tlsph {
namespace {

using sweep::Dependences;
using sweep::RegionLaw;
using sweep::Table;

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

sweep::Level level_of(Instructions instructions) {
  switch (instructions) {
    case Instructions::baseline:
      return sweep::Level::baseline;
    case Instructions::avx2:
      return sweep::Level::avx2;
    case Instructions::avx512:
      return sweep::Level::avx512;
    case Instructions::widest:
      break;
  }
  return sweep::widest_level();
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

template <int D>
RegionLaw<D> law_of(const AnyLaw<D>& any, const sweep::Kernels<D>& kernels) {
  return std::visit(
      [&](const auto& law) -> RegionLaw<D> {
        using Law = std::decay_t<decltype(law)>;
        const sweep::LawConstants constants{law.lambda(), law.mu()};
        if constexpr (Law::name == LinearElastic<D>::name)
          return {kernels.linear_elastic, constants, nullptr};
        else if constexpr (Law::name == StVenantKirchhoff<D>::name)
          return {kernels.st_venant_kirchhoff, constants, nullptr};
        else if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::strain>>)
          return {kernels.neo_hookean, constants, nullptr};
        else
          return {nullptr, constants, &any};
      },
      any);
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
struct Sweep<D>::Parts {
  const Discretisation<D>& disc;
  int threads;
  sweep::Shared<D> shared;
  RowStorage gradient, divergence, rows;
  std::vector<double> gradient_weights, divergence_weights;  // where modes are a direction of them
  std::vector<float> gradient_single, divergence_single;
  Neighbours rows_pattern;
  ScalarField inverse_mass;  // of general rows; empty if there are none
  std::vector<std::unique_ptr<sweep::Thread<D>>> thread;
  std::vector<char> good;
  std::vector<double> curve_values;
  StorageReport storage;

  Parts(const Discretisation<D>& discretisation, const SweepOptions& options)
      : disc(discretisation), threads(std::max(1, options.threads)) {
    shared.disc = &disc;
    shared.kernels = &sweep::kernels<D>(level_of(options.instructions));
    for (const Region<D>& region : disc.regions)
      shared.laws.push_back(law_of<D>(region.law, *shared.kernels));
    shared.pressures.assign(disc.loads.size(), 0.0);
    curve_values.assign(disc.constraints.curves.size(), 0.0);
    store_operators(options.single_weights);
    plan();
  }

  void store_operators(bool single) {
    inverse_mass = disc.mass.cwiseInverse();
    const Neighbours& gradient_pattern = disc.gradient.pattern();
    const Neighbours& divergence_pattern = disc.divergence.pattern();
    add_modes();
    const std::span<const double> g =
        shared.modes ? std::span<const double>(gradient_weights) : disc.gradient.weights();
    const std::span<const double> d =
        shared.modes ? std::span<const double>(divergence_weights) : disc.divergence.weights();
    const int directions = shared.modes ? D + 1 : D;
    gradient = share_rows(gradient_pattern, g, directions);
    divergence = with_row_factors(share_rows(divergence_pattern, d, directions), inverse_mass);
    set_stencils(shared.gradient, gradient);
    set_stencils(shared.divergence, divergence);
    set_general(shared.gradient, gradient_pattern, g.data());
    set_general(shared.divergence, divergence_pattern, d.data());
    shared.divergence.row_scale = inverse_mass.data();
    if (single) {
      gradient_single = singles(gradient, g);
      divergence_single = singles(divergence, d);
      shared.gradient.weight_single = gradient_single.data();
      shared.divergence.weight_single = divergence_single.data();
    }
    storage = report(gradient, gradient_pattern);
    add(report(divergence, divergence_pattern));
    const SparseMatrix* matrix = nullptr;
    if (disc.viscosity.nonZeros() > 0)
      matrix = &disc.viscosity;
    else if (disc.stiffness.nonZeros() > 0 && !shared.modes)
      matrix = &disc.stiffness;
    shared.has_rows = matrix != nullptr;
    shared.viscous = matrix == &disc.viscosity;
    if (matrix != nullptr) {
      rows_pattern = pattern_of(*matrix);
      const std::span<const double> values(matrix->valuePtr(),
                                           static_cast<std::size_t>(matrix->nonZeros()));
      rows = with_row_factors(share_rows(rows_pattern, values, 1), inverse_mass);
      set_stencils(shared.rows, rows);
      set_general(shared.rows, rows_pattern, values.data());
      shared.rows.row_scale = inverse_mass.data();
      add(report(rows, rows_pattern));
    }
    release_unused();
  }

  void add(const StorageReport& other) {
    storage.stencil_rows += other.stencil_rows;
    storage.distinct_stencils += other.distinct_stencils;
    storage.general_rows += other.general_rows;
    storage.bytes += other.bytes;
  }

  /// Copies that only general rows would read.
  void release_unused() {
    const auto all_stencils = [](const RowStorage& storage_of) {
      return std::ranges::all_of(storage_of.runs,
                                 [](const RowRun& run) { return run.stencil != no_stencil; });
    };
    if (all_stencils(gradient)) gradient_weights = {};
    if (all_stencils(divergence)) divergence_weights = {};
  }

  /// The cell stabiliser S = Aᵀ κ A as a direction more: A u beside G u, −Aᵀ κ beside D.
  void add_modes() {
    if constexpr (D == 2) {
      if (disc.cell_modulus.size() == 0) return;
      const SparseMatrix A = hourglass_rows(disc.particles, disc.gradient);
      if (!same_pattern(disc.gradient.pattern(), A)) return;
      const SparseMatrix force = SparseMatrix(-(disc.cell_modulus.asDiagonal() * A)).transpose();
      if (!same_pattern(disc.divergence.pattern(), force)) return;
      gradient_weights = with_direction(disc.gradient.weights(), D, A.valuePtr());
      divergence_weights = with_direction(disc.divergence.weights(), D, force.valuePtr());
      shared.modes = true;
    }
  }

  void plan() {
    Dependences dep;
    dep.points = disc.points.size();
    dep.nodes = disc.nodes();
    column_range(disc.gradient.pattern(), dep.gradient_low, dep.gradient_high);
    column_range(disc.divergence.pattern(), dep.divergence_low, dep.divergence_high);
    dep.point_readers = last_reader(disc.gradient.pattern(), disc.nodes());
    if (shared.has_rows) {
      column_range(rows_pattern, dep.rows_low, dep.rows_high);
      dep.row_readers = last_reader(rows_pattern, disc.nodes());
    }
    std::vector<int> regions;
    if (disc.regions.size() > 1) {
      regions.assign(static_cast<std::size_t>(disc.points.size()), 0);
      for (std::size_t r = 0; r < disc.regions.size(); ++r)
        for (const int s : disc.regions[r].points)
          regions[static_cast<std::size_t>(s)] = static_cast<int>(r);
    }
    const BoundaryForces<D> booked(disc);
    shared.constrained.assign(booked.nodes.size() * D, 0);
    for (const auto* list : {&booked.fixed, &booked.held, &booked.moved})
      for (const Index slot : *list) shared.constrained[static_cast<std::size_t>(slot)] = 1;
    std::vector<sweep::NodeLoad> loads;
    for (std::size_t l = 0; l < disc.loads.size(); ++l)
      for (std::size_t k = 0; k < disc.loads[l].dof.size(); ++k) {
        const Index dof = disc.loads[l].dof[k];
        loads.push_back({dof, disc.loads[l].weight[k] * inverse_mass[dof / D], l});
      }
    std::ranges::stable_sort(loads, {}, &sweep::NodeLoad::dof);
    const sweep::Operators operators{&gradient.runs, &divergence.runs,
                                     shared.has_rows ? &rows.runs : nullptr};
    for (int t = 0; t < threads; ++t) {
      const Index first = disc.nodes() * t / threads;
      const Index last = disc.nodes() * (t + 1) / threads;
      thread.push_back(std::make_unique<sweep::Thread<D>>(
          shared, sweep::make_plan(dep, operators, regions, booked.nodes, loads, D, first, last,
                                   threads == 1)));
    }
    good.assign(static_cast<std::size_t>(threads), 1);
    for (std::size_t t = 0; t < thread.size(); ++t)
      thread[t]->observe_points(
          t == 0 ? 0 : thread[t]->first_point(),
          t + 1 == thread.size() ? disc.points.size() : thread[t + 1]->first_point());
  }

  [[nodiscard]] bool all_good() const {
    return std::ranges::all_of(good, [](char is) { return is != 0; });
  }

  void evaluate_loads(double time) {
    for (std::size_t l = 0; l < disc.loads.size(); ++l)
      shared.pressures[l] = value(disc.loads[l].curve, time);
  }

  void pass(const sweep::StepData<D>& step) {
    if (threads == 1) {
      good[0] = thread[0]->before(step) && thread[0]->after(step) ? 1 : 0;
      return;
    }
#pragma omp parallel num_threads(threads)
    {
      const auto t = static_cast<std::size_t>(omp_get_thread_num());
      good[t] = thread[t]->before(step) ? 1 : 0;
#pragma omp barrier
      if (good[t] != 0) good[t] = thread[t]->after(step) ? 1 : 0;
    }
  }

  /// Takes back what nodes have gone of the step and says what is wrong with the state.
  void fail(State<D>& state, double kick, double dt) {
    for (const auto& part : thread)
      for (Index dof = part->first() * D; dof < part->reached() * D; ++dof)
        if (disc.inverse_mass.data()[dof] != 0.0) state.u.data()[dof] -= dt * state.v.data()[dof];
    evaluate_unchecked<D>(disc, state);
    for (const auto& part : thread)
      for (Index dof = part->first() * D; dof < part->reached() * D; ++dof)
        state.v.data()[dof] -= kick * disc.inverse_mass.data()[dof] * state.f.data()[dof];
    tlsph::evaluate<D>(disc, state);
  }

  void move(State<D>& state, double dt, BoundaryForces<D>& forces) {
    for (std::size_t c = 0; c < curve_values.size(); ++c)
      curve_values[c] = value(disc.constraints.curves[c], state.time);
    for (std::size_t k = 0; k < forces.moved.size(); ++k) {
      const auto& motion = disc.constraints.moved[k];
      const double next = curve_values[motion.curve];
      state.v.data()[motion.dof] = (next - forces.u.data()[forces.moved[k]]) / dt;
      state.u.data()[motion.dof] = next;
      forces.largest_speed = std::max(forces.largest_speed, std::abs(state.v.data()[motion.dof]));
    }
  }
};

template <int D>
bool Sweep<D>::possible(const Discretisation<D>& disc) {
  const bool signals =
      !disc.gradient_terms.empty() || !disc.force_terms.empty() || !disc.stress_values.empty();
  const bool rows_of_both = disc.viscosity.nonZeros() > 0 && disc.stiffness.nonZeros() > 0;
  return disc.ghosts == nullptr && !signals && !disc.gradient.per_component() &&
         !disc.divergence.per_component() && !rows_of_both;
}

bool available(Instructions instructions) {
  return instructions == Instructions::widest || level_of(instructions) <= sweep::widest_level();
}

double peak_multiply_adds(Index rounds) {
  using Clock = std::chrono::steady_clock;
  double sum = 0.0;
  const auto start = Clock::now();
  const Index done = sweep::kernels<1>(sweep::widest_level()).multiply_adds(rounds, sum);
  const std::chrono::duration<double> seconds = Clock::now() - start;
  return sum > 0.0 ? static_cast<double>(done) / seconds.count() : 0.0;
}

std::string widest_instructions() {
  switch (sweep::widest_level()) {
    case sweep::Level::avx512:
      return "avx512";
    case sweep::Level::avx2:
      return "avx2";
    case sweep::Level::baseline:
      break;
  }
  return "baseline";
}

template <int D>
Sweep<D>::Sweep(const Discretisation<D>& disc, const SweepOptions& options)
    : parts_(std::make_unique<Parts>(disc, options)) {}

template <int D>
Sweep<D>::Sweep(Sweep&&) noexcept = default;

template <int D>
Sweep<D>::~Sweep() = default;

template <int D>
BoundaryForces<D> Sweep<D>::boundary_forces() const {
  return BoundaryForces<D>(parts_->disc);
}

template <int D>
StorageReport Sweep<D>::storage() const {
  return parts_->storage;
}

template <int D>
void Sweep<D>::step(State<D>& state, double dt, double next_time, BoundaryForces<D>& forces) {
  Parts& parts = *parts_;
  const Discretisation<D>& disc = parts.disc;
  parts.evaluate_loads(state.time);
  if constexpr (D > 1)
    if (disc.has_body_force()) forces.moment_of_mass = moment_of_mass<D>(disc, state.u);
  const double kick = 0.5 * (state.last_dt + dt);
  const sweep::StepData<D> step{state.u.data(),          state.v.data(), kick, dt,
                                &parts.shared.pressures, &forces};
  parts.pass(step);
  if (!parts.all_good()) parts.fail(state, kick, dt);
  forces.viscous_power = 0.0;
  forces.viscous_power_after = 0.0;
  forces.largest_speed = 0.0;
  for (const auto& part : parts.thread) {
    forces.viscous_power += part->viscous_power;
    forces.viscous_power_after += part->viscous_power_after;
    forces.largest_speed = std::max(forces.largest_speed, part->largest_speed);
  }
  ++state.step;
  state.time = next_time;
  state.last_dt = dt;
  parts.move(state, dt, forces);
}

template <int D>
void Sweep<D>::evaluate(State<D>& state) {
  Parts& parts = *parts_;
  parts.evaluate_loads(state.time);
  sweep::StepData<D> step;
  step.u = state.u.data();
  step.v = state.v.data();
  step.pressures = &parts.shared.pressures;
  step.observed = &state;
  parts.pass(step);
  if (!parts.all_good()) tlsph::evaluate<D>(parts.disc, state);  // says where
}

template class Sweep<1>;
template class Sweep<2>;

}  // namespace tlsph

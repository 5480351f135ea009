#include "tlsph/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "stiffness.hpp"
#include "storage.hpp"
#include "tlsph/core/cpu_clock.hpp"
#include "tlsph/core/team.hpp"
#include "worker.hpp"

namespace tlsph {
namespace {

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

}  // namespace

template <int D>
struct Sweep<D>::Parts {
  const Discretisation<D>& disc;
  int threads;
  TeamChoice choice;
  sweep::Storage<D> storage;
  using Workers = std::vector<std::unique_ptr<sweep::Worker<D>>>;
  sweep::SweepBody<D> shared;
  Workers points;  // that go by the points
  std::optional<sweep::Stiffness<D>> stiffness;
  sweep::SweepBody<D> shared_stiffness;
  Workers products;  // that multiply by that stiffness, if there is one
  std::vector<char> good;
  std::vector<double> curve_values;

  Parts(const Discretisation<D>& discretisation, const SweepOptions& options)
      : disc(discretisation),
        threads(std::max(1, options.threads)),
        storage(discretisation, options.single_weights) {
    shared.disc = &disc;
    shared.loops = &sweep::loops<D>(level_of(options.instructions));
    shared.gradient = storage.gradient_table;
    shared.divergence = storage.divergence_table;
    shared.rows = storage.rows_table;
    shared.modes = storage.modes;
    shared.viscous = storage.viscous;
    shared.has_rows = storage.has_rows;
    shared.body_force = disc.has_body_force() && !options.linearised;
    shared.laws = sweep::region_laws<D>(disc, *shared.loops, options.linearised);
    shared.pressures.assign(disc.loads.size(), 0.0);
    curve_values.assign(disc.constraints.curves.size(), 0.0);
    good.assign(static_cast<std::size_t>(threads), 1);
    const BoundaryForces<D> booked(disc);
    shared.constrained.assign(booked.nodes.size() * D, 0);
    for (const auto* list : {&booked.fixed, &booked.held, &booked.moved})
      for (const Index slot : *list) shared.constrained[static_cast<std::size_t>(slot)] = 1;
    const std::vector<sweep::NodeLoad> loads =
        options.linearised ? std::vector<sweep::NodeLoad>{} : node_loads();
    plan_points(booked.nodes, loads);
    if (options.form != StepForm::points && !options.linearised)
      plan_products(booked.nodes, loads, options.form);
  }

  [[nodiscard]] std::vector<sweep::NodeLoad> node_loads() const {
    std::vector<sweep::NodeLoad> loads;
    for (std::size_t l = 0; l < disc.loads.size(); ++l)
      for (std::size_t k = 0; k < disc.loads[l].dof.size(); ++k) {
        const Index dof = disc.loads[l].dof[k];
        loads.push_back({dof, disc.loads[l].weight[k] * storage.inverse_mass[dof / D], l});
      }
    std::ranges::stable_sort(loads, {}, &sweep::NodeLoad::dof);
    return loads;
  }

  [[nodiscard]] Workers team(const sweep::SweepBody<D>& common, const sweep::Dependences& dep,
                             const sweep::Operators& operators, const std::vector<int>& regions,
                             const std::vector<Index>& booked,
                             const std::vector<sweep::NodeLoad>& loads) const {
    Workers result;
    for (int t = 0; t < threads; ++t) {
      const Index first = disc.nodes() * t / threads;
      const Index last = disc.nodes() * (t + 1) / threads;
      result.push_back(std::make_unique<sweep::Worker<D>>(
          common,
          sweep::make_plan(dep, operators, regions, booked, loads, D, first, last, threads == 1)));
    }
    return result;
  }

  void plan_points(const std::vector<Index>& booked, const std::vector<sweep::NodeLoad>& loads) {
    const sweep::Operators operators{&storage.gradient.runs, &storage.divergence.runs,
                                     storage.has_rows ? &storage.rows.runs : nullptr};
    points = team(shared, storage.dependences(), operators, sweep::regions_of_points(disc), booked,
                  loads);
    for (std::size_t t = 0; t < points.size(); ++t)
      points[t]->observe_points(
          t == 0 ? 0 : points[t]->first_point(),
          t + 1 == points.size() ? disc.points.size() : points[t + 1]->first_point());
  }

  void plan_products(const std::vector<Index>& booked, const std::vector<sweep::NodeLoad>& loads,
                     StepForm form) {
    const bool asked_for = form == StepForm::stiffness;
    stiffness = sweep::stiffness_of(disc, storage, shared.laws,
                                    asked_for ? disc.nodes() : 64 + disc.nodes() / 16);
    if (stiffness && !asked_for && stiffness->work >= sweep::work_of_points(disc))
      stiffness.reset();
    if (!stiffness) return;
    shared_stiffness = shared;
    shared_stiffness.has_blocks = shared_stiffness.has_rows = true;
    shared_stiffness.blocks = stiffness->table();
    shared_stiffness.modes = false;
    const std::vector<RowRun> none;
    const std::vector<RowRun> all = {{0, static_cast<int>(disc.nodes()), 0, no_stencil}};
    products = team(shared_stiffness, stiffness->dependences(),
                    {&none, &all, &stiffness->runs, &stiffness->patches}, {}, booked, loads);
  }

  [[nodiscard]] bool all_good() const {
    return std::ranges::all_of(good, [](char is) { return is != 0; });
  }

  void evaluate_loads(double time) {
    for (std::size_t l = 0; l < disc.loads.size(); ++l)
      shared.pressures[l] = value(disc.loads[l].curve, time);
  }

  [[nodiscard]] const Workers& stepping() const { return stiffness ? products : points; }

  /// The parts are the same whoever makes them, and so are the results.
  void pass(const Workers& thread, const sweep::StepArguments<D>& step) {
    in_parts(
        choice, 1.0, threads, threads,
        [&](int part) {
          const auto t = static_cast<std::size_t>(part);
          good[t] = thread[t]->before(step) ? 1 : 0;
        },
        [&](int part) {
          const auto t = static_cast<std::size_t>(part);
          if (good[t] != 0) good[t] = thread[t]->after(step) ? 1 : 0;
        });
  }

  /// Takes back what nodes have gone of the step and says what is wrong with the state.
  [[noreturn]] void fail(State<D>& state, double kick, double dt) {
    for (const auto& part : stepping())
      for (Index dof = part->first() * D; dof < part->reached() * D; ++dof)
        if (disc.inverse_mass.data()[dof] != 0.0) state.u.data()[dof] -= dt * state.v.data()[dof];
    evaluate_unchecked<D>(disc, state);
    for (const auto& part : stepping())
      for (Index dof = part->first() * D; dof < part->reached() * D; ++dof)
        state.v.data()[dof] -= kick * disc.inverse_mass.data()[dof] * state.f.data()[dof];
    report_failure<D>(disc, state);
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
  return disc.memory() == 0 && disc.ghosts == nullptr && !signals && disc.reactions.empty() &&
         !disc.gradient.per_component() && !disc.divergence.per_component() && !rows_of_both;
}

bool available(Instructions instructions) {
  return instructions == Instructions::widest || level_of(instructions) <= sweep::widest_level();
}

double peak_multiply_adds(Index rounds) {
  double sum = 0.0;
  const double start = cpu_seconds();
  const Index done = sweep::loops<1>(sweep::widest_level()).multiply_adds(rounds, sum);
  const double seconds = cpu_seconds() - start;
  return sum > 0.0 ? static_cast<double>(done) / seconds : 0.0;
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
const sweep::Storage<D>& Sweep<D>::operators() const {
  return parts_->storage;
}

template <int D>
StorageReport Sweep<D>::storage() const {
  StorageReport report = parts_->storage.report;
  if (parts_->stiffness) report.bytes = parts_->stiffness->bytes();
  return report;
}

template <int D>
std::optional<double> Sweep<D>::stiffness_multiply_adds() const {
  return parts_->stiffness ? std::optional(parts_->stiffness->multiply_adds) : std::nullopt;
}

template <int D>
void Sweep<D>::step(State<D>& state, double dt, double next_time, BoundaryForces<D>& forces) {
  Parts& parts = *parts_;
  const Discretisation<D>& disc = parts.disc;
  parts.evaluate_loads(state.time);
  if constexpr (D > 1)
    if (disc.has_body_force()) forces.moment_of_mass = moment_of_mass<D>(disc, state.u);
  std::ranges::copy(parts.shared.pressures, forces.load_values.begin());
  const double kick = 0.5 * (state.last_dt + dt);
  const sweep::StepArguments<D> step{state.u.data(),          state.v.data(), kick, dt,
                                     &parts.shared.pressures, &forces};
  parts.pass(parts.stepping(), step);
  if (!parts.all_good()) parts.fail(state, kick, dt);
  forces.viscous_power = 0.0;
  forces.viscous_power_after = 0.0;
  forces.largest_speed = 0.0;
  for (const auto& part : parts.stepping()) {
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
  sweep::StepArguments<D> step;
  step.u = state.u.data();
  step.v = state.v.data();
  step.pressures = &parts.shared.pressures;
  step.observed = &state;
  parts.pass(parts.points, step);
  if (parts.all_good()) return;
  evaluate_unchecked<D>(parts.disc, state);
  report_failure<D>(parts.disc, state);
}

template class Sweep<1>;
template class Sweep<2>;

}  // namespace tlsph

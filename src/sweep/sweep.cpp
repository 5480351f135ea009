#include "tlsph/sweep/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "stiffness.hpp"
#include "tlsph/core/team.hpp"
#include "worker.hpp"

namespace tlsph {

template <int D>
struct Sweep<D>::Parts {
  using Workers = std::vector<std::unique_ptr<sweep::Worker<D>>>;

  const Discretisation<D>& body;
  int threads;
  TeamChoice choice;
  sweep::Storage<D> storage;
  sweep::SweepBody<D> shared;
  Workers points;  // that go by the points
  std::optional<sweep::Stiffness<D>> stiffness;
  sweep::Operators product;
  Workers products;  // that multiply by that stiffness, if there is one
  std::vector<char> good;
  std::vector<double> curve_values;

  Parts(const Discretisation<D>& discretisation, const SweepOptions& options)
      : body(discretisation),
        threads(std::max(1, options.threads)),
        storage(discretisation, options.single_weights),
        shared{.discretisation = body, .loops = sweep::loops<D>(options.instructions)},
        good(static_cast<std::size_t>(threads), 1),
        curve_values(body.constraints.curves.size(), 0.0) {
    shared.laws = sweep::region_laws<D>(body, shared.loops, options.linearised);
    if (body.has_body_force() && !options.linearised) shared.body_force = body.body_force;
    shared.pressures.assign(body.loads.size(), 0.0);
    const BoundaryForces<D> booked(body);
    shared.constrained.assign(booked.nodes.size() * D, 0);
    for (const auto* list : {&booked.fixed, &booked.held, &booked.moved})
      for (const Index slot : *list) shared.constrained[static_cast<std::size_t>(slot)] = 1;

    sweep::PlanInput input = storage.plan_input();
    input.regions = sweep::regions_of_points(body);
    const auto workers = [&](const sweep::Operators& operators, sweep::PlanInput& plan) {
      plan.components = D;
      plan.booked = booked.nodes;
      if (!options.linearised) plan.loads = node_loads();
      Workers result;
      for (int t = 0; t < threads; ++t)
        result.push_back(std::make_unique<sweep::Worker<D>>(
            shared, operators,
            make_plan(plan, body.nodes() * t / threads, body.nodes() * (t + 1) / threads,
                      threads == 1)));
      return result;
    };
    points = workers(storage.tables, input);
    for (std::size_t t = 1; t < points.size(); ++t)
      points[t - 1]->last_observed = points[t]->first_observed = points[t]->first_point();
    points.back()->last_observed = body.points.size();
    if (options.form == StepForm::points || options.linearised) return;
    compose(options.form == StepForm::stiffness);
    if (!stiffness) return;
    const std::vector<RowRun> all = {{0, static_cast<int>(body.nodes()), 0, no_stencil}};
    input = stiffness->plan_input(all);
    products = workers(product, input);
  }

  [[nodiscard]] std::vector<sweep::NodeLoad> node_loads() const {
    std::vector<sweep::NodeLoad> loads;
    for (std::size_t l = 0; l < body.loads.size(); ++l)
      for (std::size_t k = 0; k < body.loads[l].dof.size(); ++k) {
        const Index dof = body.loads[l].dof[k];
        loads.push_back({dof, body.loads[l].weight[k] * storage.inverse_mass[dof / D], l});
      }
    std::ranges::stable_sort(loads, {}, &sweep::NodeLoad::dof);
    return loads;
  }

  /// The stiffness, if there is one and it is asked for or less work.
  void compose(bool asked_for) {
    stiffness = sweep::stiffness_of(body, storage, shared.laws,
                                    asked_for ? body.nodes() : 64 + body.nodes() / 16);
    if (stiffness && !asked_for && stiffness->work >= sweep::work_of_points(body))
      stiffness.reset();
    if (!stiffness) return;
    product.rows = stiffness->table();
    product.has_rows = product.blocks = true;
  }

  [[nodiscard]] const Workers& stepping() const { return stiffness ? products : points; }

  /// False where a state has no stress. The parts are the same whoever makes them, and so are the
  /// results.
  [[nodiscard]] bool pass(const Workers& workers, const sweep::StepArguments<D>& step) {
    for (std::size_t l = 0; l < body.loads.size(); ++l)
      shared.pressures[l] = value(body.loads[l].curve, step.state.time);
    const auto phase = [&](auto make) {
      return [&, make](int part) {
        const auto t = static_cast<std::size_t>(part);
        good[t] = good[t] != 0 && ((*workers[t]).*make)(step);
      };
    };
    std::ranges::fill(good, 1);
    in_parts(choice, 1.0, threads, threads, phase(&sweep::Worker<D>::before),
             phase(&sweep::Worker<D>::after));
    return std::ranges::find(good, 0) == good.end();
  }

  /// Takes back what nodes have gone of the step and says what is wrong with the state.
  [[noreturn]] void fail(State<D>& state, double kick, double dt) {
    const auto for_moved = [&](const auto& act) {
      for (const auto& part : stepping())
        for (Index dof = part->first() * D; dof < part->reached() * D; ++dof) act(dof);
    };
    for_moved([&](Index dof) {
      if (body.inverse_mass.data()[dof] != 0.0) state.u.data()[dof] -= dt * state.v.data()[dof];
    });
    evaluate_unchecked<D>(body, state);
    for_moved([&](Index dof) {
      state.v.data()[dof] -= kick * body.inverse_mass.data()[dof] * state.f.data()[dof];
    });
    report_failure<D>(body, state);
  }

  void move(State<D>& state, double dt, BoundaryForces<D>& forces) {
    for (std::size_t c = 0; c < curve_values.size(); ++c)
      curve_values[c] = value(body.constraints.curves[c], state.time);
    for (std::size_t k = 0; k < forces.moved.size(); ++k) {
      const auto& motion = body.constraints.moved[k];
      const double next = curve_values[motion.curve];
      state.v.data()[motion.dof] = (next - forces.u.data()[forces.moved[k]]) / dt;
      state.u.data()[motion.dof] = next;
      forces.largest_speed = std::max(forces.largest_speed, std::abs(state.v.data()[motion.dof]));
    }
  }
};

template <int D>
bool Sweep<D>::possible(const Discretisation<D>& body) {
  const bool signals =
      !body.gradient_terms.empty() || !body.force_terms.empty() || !body.stress_values.empty();
  const bool rows_of_both = body.viscosity.nonZeros() > 0 && body.stiffness.nonZeros() > 0;
  return body.memory() == 0 && body.ghosts == nullptr && !signals && body.reactions.empty() &&
         !body.gradient.per_component() && !body.divergence.per_component() && !rows_of_both;
}

template <int D>
Sweep<D>::Sweep(const Discretisation<D>& body, const SweepOptions& options)
    : parts_(std::make_unique<Parts>(body, options)) {}

template <int D>
Sweep<D>::Sweep(Sweep&&) noexcept = default;

template <int D>
Sweep<D>::~Sweep() = default;

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
  if (D > 1 && parts.body.has_body_force())
    forces.moment_of_mass = moment_of_mass<D>(parts.body, state.u);
  const double kick = 0.5 * (state.last_dt + dt);
  if (!parts.pass(parts.stepping(), {state, &forces, kick, dt})) parts.fail(state, kick, dt);
  std::ranges::copy(parts.shared.pressures, forces.load_values.begin());
  forces.viscous_power = forces.viscous_power_after = forces.largest_speed = 0.0;
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
  if (parts_->pass(parts_->points, {state})) return;
  evaluate_unchecked<D>(parts_->body, state);
  report_failure<D>(parts_->body, state);
}

template class Sweep<1>;
template class Sweep<2>;

}  // namespace tlsph

#include "tlsph/dynamics/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph {
namespace {

/// x × f in 2D, zero in 1D.
template <int D>
double cross(const Vector<D>& x, const Vector<D>& force) {
  if constexpr (D == 2)
    return x[0] * force[1] - x[1] * force[0];
  else
    return 0.0;
}

/// Forces, displacements and velocities by degree of freedom (`slots` nullptr), or those a sweep
/// gathered, by slot; stresses `P` where reactions are made of them, which no sweep gathers.
template <int D>
struct Books {
  const Discretisation<D>& disc;
  const double* f;
  const double* u;
  const double* before;  // velocity at t_{n−½}
  const double* P;       // all stresses, where reactions are made of them
  const BoundaryForces<D>* slots;
  double time;
  double kick;
  bool small_strain;

  [[nodiscard]] Index slot(const std::vector<Index>& list, std::size_t k, Index dof) const {
    return slots == nullptr ? dof : list[k];
  }
  /// Of a force on a degree of freedom about the origin, in 2D; with positions of the reference
  /// configuration for linear elasticity, whose energy is not invariant under finite rotations.
  [[nodiscard]] double arm(Index dof, Index slot) const requires(D == 2) {
    const bool along_y = (dof & 1) != 0;
    double x = disc.particles.X.data()[dof ^ 1];
    if (!small_strain) x += u[slot ^ 1];
    return along_y ? x : -x;
  }
};

/// The way that forces at t_n act on: parts of the half steps before and after.
struct Ways {
  double before = 0.0, after = 0.0;
};

/// Reactions of constraints from what their nodes lack to their accelerations; where those are made
/// of stresses, the inertia of moved nodes.
template <int D, class Next, class Move, class Push>
void book_constraints(const Books<D>& books, const Next& next, const Move& move, const Push& push) {
  const Discretisation<D>& disc = books.disc;
  const std::vector<Index> none;
  const auto still = [&](const std::vector<Index>& dofs, const std::vector<Index>& list) {
    for (std::size_t k = 0; k < dofs.size(); ++k) {
      const Index slot = books.slot(list, k, dofs[k]);
      push(dofs[k], slot, -books.f[slot]);
    }
  };
  if (disc.reactions.empty()) {
    still(disc.constraints.fixed, books.slots == nullptr ? none : books.slots->fixed);
    still(disc.constraints.held, books.slots == nullptr ? none : books.slots->held);
  }
  const std::vector<Index>& moved = books.slots == nullptr ? none : books.slots->moved;
  for (std::size_t k = 0; k < disc.constraints.moved.size(); ++k) {
    const Index dof = disc.constraints.moved[k].dof;
    const Index slot = books.slot(moved, k, dof);
    const double change = next(slot, dof) - books.before[slot];
    const double lacking = disc.reactions.empty() ? -books.f[slot] : 0.0;
    const double reaction = disc.mass[dof / D] * change / books.kick + lacking;
    move(dof, slot, reaction);
    push(dof, slot, reaction);
  }
}

/// What the forces at t_n do on half of each way, where the velocity is `before(slot, dof)` and
/// `next(slot, dof)`.
template <int D, class Before, class Next>
void book_ways(Ledger<D>& ledger, const Books<D>& books, const Ways& ways, const Before& before,
               const Next& next, const Vector<D>& moment_of_mass) {
  const Discretisation<D>& disc = books.disc;
  const double time = 0.5 * (ways.before + ways.after);
  double work = 0.0;
  double impulse[D] = {};
  double angular = 0.0;
  const auto push = [&](Index dof, Index slot, double force) {
    impulse[dof % D] += force;
    if constexpr (D > 1) angular += books.arm(dof, slot) * force;
  };
  const auto move = [&](Index dof, Index slot, double force) {
    work += force * (ways.before * before(slot, dof) + ways.after * next(slot, dof));
  };
  const std::vector<Index> none;
  for (std::size_t l = 0; l < disc.loads.size(); ++l) {
    const Load& load = disc.loads[l];
    const std::vector<Index>& list = books.slots == nullptr ? none : books.slots->loads[l];
    const double pressure =
        books.slots == nullptr ? value(load.curve, books.time) : books.slots->load_values[l];
    for (std::size_t k = 0; k < load.dof.size(); ++k) {
      const Index slot = books.slot(list, k, load.dof[k]);
      const double force = pressure * load.weight[k];
      move(load.dof[k], slot, force);
      push(load.dof[k], slot, force);
    }
  }
  for (const ReactionTerm& term : disc.reactions) {
    const double force = term.weight * books.P[term.slot];
    move(term.dof, term.dof, force);
    push(term.dof, term.dof, force);
  }
  book_constraints(books, next, move, push);
  ledger.external_work += 0.5 * work;
  for (int i = 0; i < D; ++i) ledger.impulse[i] += time * impulse[i];
  ledger.angular_impulse += time * angular;
  if (disc.has_body_force()) {
    ledger.impulse += time * disc.mass.sum() * disc.body_force;
    ledger.angular_impulse += time * cross<D>(moment_of_mass, disc.body_force);
  }
}

template <int D>
Vector<D> moment_if_needed(const Discretisation<D>& disc, const VectorField<D>& u) {
  return D > 1 && disc.has_body_force() ? moment_of_mass<D>(disc, u) : Vector<D>(Vector<D>::Zero());
}

}  // namespace

template <int D>
Vector<D> moment_of_mass(const Discretisation<D>& disc, const VectorField<D>& u) {
  Vector<D> sum = disc.particles.X.transpose() * disc.mass;
  if (!disc.small_strain()) sum += u.transpose() * disc.mass;
  return sum;
}

template <int D>
BoundaryForces<D>::BoundaryForces(const Discretisation<D>& disc) {
  const auto add = [&](Index dof) { nodes.push_back(dof / D); };
  for (const Load& load : disc.loads) std::ranges::for_each(load.dof, add);
  std::ranges::for_each(disc.constraints.fixed, add);
  std::ranges::for_each(disc.constraints.held, add);
  for (const auto& motion : disc.constraints.moved) add(motion.dof);
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const auto slot = [&](Index dof) {
    return (std::ranges::lower_bound(nodes, dof / D) - nodes.begin()) * D + dof % D;
  };
  const auto slots = [&](const std::vector<Index>& dofs) {
    std::vector<Index> list(dofs.size());
    std::ranges::transform(dofs, list.begin(), slot);
    return list;
  };
  for (const Load& load : disc.loads) loads.push_back(slots(load.dof));
  load_values.assign(disc.loads.size(), 0.0);
  fixed = slots(disc.constraints.fixed);
  held = slots(disc.constraints.held);
  for (const auto& motion : disc.constraints.moved) moved.push_back(slot(motion.dof));
  const auto rows = static_cast<Index>(nodes.size());
  f = u = v = VectorField<D>::Zero(rows, D);
}

template <int D>
void Ledger<D>::arrive(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const double way = state.last_dt;
  const Books<D> books{disc,           state.f.data(),   state.u.data(),
                       state.v.data(), state.P.data(),   nullptr,
                       state.time,     0.5 * (way + dt), disc.small_strain()};
  book_ways<D>(
      *this, books, {way, 0.0}, [&](Index, Index dof) { return state.v.data()[dof]; },
      [&](Index, Index dof) { return next_velocity<D>(disc, state, dt, dof); },
      moment_if_needed<D>(disc, state.u));
  if (disc.viscosity.nonZeros() > 0)
    dissipated += 0.5 * way * state.viscous.cwiseProduct(state.v).sum();
}

template <int D>
void Ledger<D>::depart(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const Books<D> books{disc,
                       state.f.data(),
                       state.u.data(),
                       state.v.data(),
                       state.P.data(),
                       nullptr,
                       state.time,
                       0.5 * (state.last_dt + dt),
                       disc.small_strain()};
  const auto next = [&](Index, Index dof) { return next_velocity<D>(disc, state, dt, dof); };
  book_ways<D>(*this, books, {0.0, dt}, next, next, moment_if_needed<D>(disc, state.u));
  if (disc.viscosity.nonZeros() > 0) {
    double power = 0.0;
    for (Index dof = 0; dof < state.v.size(); ++dof)
      power += state.viscous.data()[dof] * next_velocity<D>(disc, state, dt, dof);
    dissipated += 0.5 * dt * power;
  }
}

template <int D>
void Ledger<D>::book(const Discretisation<D>& disc, const BoundaryForces<D>& forces,
                     const State<D>& after, double time, double way, double dt, bool arrived) {
  const Books<D> books{
      disc, forces.f.data(),  forces.u.data(),    forces.v.data(), nullptr, &forces,
      time, 0.5 * (way + dt), disc.small_strain()};
  const auto next = [&](Index, Index dof) { return after.v.data()[dof]; };
  const Ways ways{arrived ? 0.0 : way, dt};
  book_ways<D>(
      *this, books, ways, [&](Index slot, Index) { return forces.v.data()[slot]; }, next,
      forces.moment_of_mass);
  dissipated +=
      0.5 * (ways.before * forces.viscous_power + ways.after * forces.viscous_power_after);
}

namespace {

/// Σ V × density(law at the state's memory, point) over the material points.
template <int D, class Density>
double sum_over_points(const Discretisation<D>& disc, const State<D>& state,
                       const Density& density) {
  double sum = 0.0;
  for (const Region<D>& region : disc.regions)
    std::visit(
        [&](const auto& law) {
          const auto at = [&](Index s) {
            sum += disc.points.V[s] * density(law.at(present(state, s)), s);
          };
          if (region.points.empty())
            for (Index s = 0; s < state.H.rows(); ++s) at(s);
          else
            for (const int s : region.points) at(s);
        },
        region.law);
  return sum;
}

}  // namespace

template <int D>
double elastic_energy(const Discretisation<D>& disc, const State<D>& state) {
  return sum_over_points(
             disc, state,
             [&](const auto& law, Index s) { return law.energy(tensor_at<D>(state.H, s)); }) +
         stabiliser_energy<D>(disc, state.u);
}

template <int D>
double dissipated_energy(const Discretisation<D>& disc, const State<D>& state) {
  if (state.memory.size() == 0) return 0.0;
  return sum_over_points(disc, state, [](const auto& law, Index) { return law.dissipated(); });
}

template <int D>
Balance<D> balance(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const bool small = disc.small_strain();
  Balance<D> result;
  for (Index q = 0; q < disc.nodes(); ++q) {
    const double m = disc.mass[q];
    Vector<D> now;
    for (int i = 0; i < D; ++i) {
      const Index dof = q * D + i;
      const NodalMotion motion = motion_of<D>(disc, state, dt, dof);
      const double change = 0.5 * state.last_dt * motion.acceleration;
      now[i] = motion.velocity;
      result.kinetic += 0.5 * m * (now[i] - change) * (now[i] + change);
      result.ripple += 0.5 * m * change * change;
    }
    const Vector<D> p = m * now;
    Vector<D> x = disc.particles.X.row(q).transpose();
    if (!small) x += state.u.row(q).transpose();
    result.linear_momentum += p;
    result.angular_momentum += cross<D>(x, p);
    result.momentum_scale += p.norm();
    result.angular_scale += x.norm() * p.norm();
    if (disc.has_body_force()) result.gravity += m * disc.body_force.dot(state.u.row(q));
  }
  result.elastic = elastic_energy(disc, state);
  result.dissipated = dissipated_energy(disc, state);
  return result;
}

#define TLSPH_INSTANTIATE(D)                                                             \
  template struct Ledger<D>;                                                             \
  template struct BoundaryForces<D>;                                                     \
  template Vector<D> moment_of_mass<D>(const Discretisation<D>&, const VectorField<D>&); \
  template double elastic_energy<D>(const Discretisation<D>&, const State<D>&);          \
  template double dissipated_energy<D>(const Discretisation<D>&, const State<D>&);       \
  template Balance<D> balance<D>(const Discretisation<D>&, const State<D>&, double);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

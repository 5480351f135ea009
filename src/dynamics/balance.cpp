#include "tlsph/dynamics/balance.hpp"

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

/// Adds work and impulse of the forces of t_n over parts of the half steps before and after it.
/// `kick`: the time that takes v_{n−½} to v_{n+½}, which is `next(dof)`.
template <int D, class Next>
void add(const Discretisation<D>& body, const BoundaryForces<D>& forces, double before,
         double after, double kick, const Next& next, WorkAndImpulse<D>& sum) {
  double work = 0.0, angular = 0.0;
  double impulse[D] = {};
  const bool small_strain = body.small_strain();
  const auto push = [&](Index dof, Index slot, double force) {
    impulse[dof % D] += force;
    if constexpr (D == 2) {
      // The arm about the origin, with positions of the reference configuration for linear
      // elasticity, whose energy is not invariant under finite rotations.
      double x = body.particles.X.data()[dof ^ 1];
      if (!small_strain) x += forces.u.data()[slot ^ 1];
      angular += ((dof & 1) != 0 ? x : -x) * force;
    }
  };
  const auto move = [&](Index dof, Index slot, double force) {
    work += force * (before * forces.v.data()[slot] + after * next(dof));
    push(dof, slot, force);
  };
  // Supports at rest do no work.
  const auto push_back = [&](const std::vector<Index>& dofs, const std::vector<Index>& slots) {
    for (std::size_t k = 0; k < dofs.size(); ++k)
      push(dofs[k], slots[k], -forces.f.data()[slots[k]]);
  };
  for (std::size_t l = 0; l < body.loads.size(); ++l)
    for (std::size_t k = 0; k < body.loads[l].dof.size(); ++k)
      move(body.loads[l].dof[k], forces.loads[l][k],
           forces.load_values[l] * body.loads[l].weight[k]);
  for (std::size_t k = 0; k < body.reactions.size(); ++k)
    move(body.reactions[k].dof, forces.reactions[k], forces.reaction_values[k]);
  // Reactions of constraints from what their nodes lack to their accelerations; where those are
  // made of stresses, the inertia of moved nodes.
  const bool lacking = body.reactions.empty();
  if (lacking) {
    push_back(body.constraints.fixed, forces.fixed);
    push_back(body.constraints.held, forces.held);
  }
  for (std::size_t k = 0; k < body.constraints.moved.size(); ++k) {
    const Index dof = body.constraints.moved[k].dof;
    const Index slot = forces.moved[k];
    const double change = next(dof) - forces.v.data()[slot];
    move(dof, slot, body.mass[dof / D] * change / kick + (lacking ? -forces.f.data()[slot] : 0.0));
  }
  const double time = 0.5 * (before + after);
  sum.external_work += 0.5 * work;
  for (int i = 0; i < D; ++i) sum.impulse[i] += time * impulse[i];
  sum.angular_impulse += time * angular;
  if (!body.has_body_force()) return;
  sum.impulse += time * body.mass.sum() * body.body_force;
  sum.angular_impulse += time * cross<D>(forces.moment_of_mass, body.body_force);
}

/// Σ V × density(law at the state's memory, point) over the material points.
template <int D, class Density>
double sum_over_points(const Discretisation<D>& body, const State<D>& state,
                       const Density& density) {
  double sum = 0.0;
  for (const Region<D>& region : body.regions)
    std::visit(
        [&](const auto& law) {
          for (Index k = 0; k < region.size(state.H.rows()); ++k) {
            const Index s = region.point(k);
            sum += body.points.V[s] * density(law.at(present(state, s)), s);
          }
        },
        region.law);
  return sum;
}

}  // namespace

template <int D>
Vector<D> moment_of_mass(const Discretisation<D>& body, const VectorField<D>& u) {
  Vector<D> sum = body.particles.X.transpose() * body.mass;
  if (!body.small_strain()) sum += u.transpose() * body.mass;
  return sum;
}

template <int D>
BoundaryForces<D>::BoundaryForces(const Discretisation<D>& body) {
  const auto add_node = [&](Index dof) { nodes.push_back(dof / D); };
  for (const Load& load : body.loads) std::ranges::for_each(load.dof, add_node);
  std::ranges::for_each(body.constraints.fixed, add_node);
  std::ranges::for_each(body.constraints.held, add_node);
  for (const auto& motion : body.constraints.moved) add_node(motion.dof);
  for (const ReactionTerm& term : body.reactions) add_node(term.dof);
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
  for (const Load& load : body.loads) loads.push_back(slots(load.dof));
  load_values.assign(body.loads.size(), 0.0);
  fixed = slots(body.constraints.fixed);
  held = slots(body.constraints.held);
  for (const auto& motion : body.constraints.moved) moved.push_back(slot(motion.dof));
  for (const ReactionTerm& term : body.reactions) reactions.push_back(slot(term.dof));
  reaction_values.assign(reactions.size(), 0.0);
  const auto rows = static_cast<Index>(nodes.size());
  f = u = v = VectorField<D>::Zero(rows, D);
}

template <int D>
void BoundaryForces<D>::gather(const Instant<D>& now) {
  const Discretisation<D>& body = now.body;
  const State<D>& state = now.state;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto row = static_cast<Index>(k);
    f.row(row) = state.f.row(nodes[k]);
    u.row(row) = state.u.row(nodes[k]);
    v.row(row) = state.v.row(nodes[k]);
  }
  for (std::size_t l = 0; l < body.loads.size(); ++l)
    load_values[l] = value(body.loads[l].curve, state.time);
  for (std::size_t k = 0; k < reactions.size(); ++k)
    reaction_values[k] = body.reactions[k].weight * state.P.data()[body.reactions[k].slot];
  if (D > 1 && body.has_body_force()) moment_of_mass = tlsph::moment_of_mass<D>(body, state.u);
  if (body.viscosity.nonZeros() == 0) return;
  viscous_power = state.viscous.cwiseProduct(state.v).sum();
  viscous_power_after = 0.0;
  for (Index dof = 0; dof < state.v.size(); ++dof)
    viscous_power_after += state.viscous.data()[dof] * next_velocity<D>(body, state, now.dt, dof);
}

template <int D>
void WorkAndImpulse<D>::add_before(const BoundaryForces<D>& forces, const Instant<D>& now) {
  const double before = now.state.last_dt;
  const auto next = [&](Index dof) { return next_velocity<D>(now.body, now.state, now.dt, dof); };
  add(now.body, forces, before, 0.0, 0.5 * (before + now.dt), next, *this);
  dissipated += 0.5 * before * forces.viscous_power;
}

template <int D>
void WorkAndImpulse<D>::add_after(const BoundaryForces<D>& forces, const Instant<D>& now) {
  const auto next = [&](Index dof) { return next_velocity<D>(now.body, now.state, now.dt, dof); };
  add(now.body, forces, 0.0, now.dt, 0.5 * (now.state.last_dt + now.dt), next, *this);
  dissipated += 0.5 * now.dt * forces.viscous_power_after;
}

template <int D>
void WorkAndImpulse<D>::add_step(const Discretisation<D>& body, const BoundaryForces<D>& forces,
                                 const State<D>& after, const Steps& steps) {
  const auto next = [&](Index dof) { return after.v.data()[dof]; };
  const double before = steps.before_added ? 0.0 : steps.before;
  add(body, forces, before, steps.after, 0.5 * (steps.before + steps.after), next, *this);
  dissipated += 0.5 * (before * forces.viscous_power + steps.after * forces.viscous_power_after);
}

template <int D>
double elastic_energy(const Discretisation<D>& body, const State<D>& state) {
  return sum_over_points(
             body, state,
             [&](const auto& law, Index s) { return law.energy(tensor_at<D>(state.H, s)); }) +
         stabiliser_energy<D>(body, state.u);
}

template <int D>
double dissipated_energy(const Discretisation<D>& body, const State<D>& state) {
  if (state.memory.size() == 0) return 0.0;
  return sum_over_points(body, state, [](const auto& law, Index) { return law.dissipated(); });
}

template <int D>
Balance<D> balance(const Instant<D>& now) {
  const Discretisation<D>& body = now.body;
  const State<D>& state = now.state;
  const bool small = body.small_strain();
  Balance<D> result;
  for (Index q = 0; q < body.nodes(); ++q) {
    const double m = body.mass[q];
    Vector<D> velocity;
    for (int i = 0; i < D; ++i) {
      const Index dof = q * D + i;
      const NodalMotion motion = now.motion(dof);
      const double change = 0.5 * state.last_dt * motion.acceleration;
      velocity[i] = motion.velocity;
      result.kinetic += 0.5 * m * (velocity[i] - change) * (velocity[i] + change);
      result.ripple += 0.5 * m * change * change;
    }
    const Vector<D> p = m * velocity;
    Vector<D> x = body.particles.X.row(q).transpose();
    if (!small) x += state.u.row(q).transpose();
    result.linear_momentum += p;
    result.angular_momentum += cross<D>(x, p);
    result.momentum_scale += p.norm();
    result.angular_scale += x.norm() * p.norm();
    if (body.has_body_force()) result.gravity += m * body.body_force.dot(state.u.row(q));
  }
  result.elastic = elastic_energy(body, state);
  result.dissipated = dissipated_energy(body, state);
  return result;
}

#define TLSPH_INSTANTIATE(D)                                                             \
  template struct WorkAndImpulse<D>;                                                     \
  template struct BoundaryForces<D>;                                                     \
  template Vector<D> moment_of_mass<D>(const Discretisation<D>&, const VectorField<D>&); \
  template double elastic_energy<D>(const Discretisation<D>&, const State<D>&);          \
  template double dissipated_energy<D>(const Discretisation<D>&, const State<D>&);       \
  template Balance<D> balance<D>(const Instant<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

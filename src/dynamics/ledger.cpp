#include "tlsph/dynamics/ledger.hpp"

#include <cmath>

namespace tlsph {
namespace {

/// x × f in 2D, zero in 1D; positions of the reference configuration for linear elasticity, whose
/// energy is not invariant under finite rotations.
template <int D>
double moment(const Discretisation<D>& disc, const State<D>& state, bool linear, Index node,
              const Vector<D>& force) {
  if constexpr (D == 2) {
    Vector<D> x = disc.particles.X.row(node).transpose();
    if (!linear) x += state.u.row(node).transpose();
    return x[0] * force[1] - x[1] * force[0];
  } else {
    return 0.0;
  }
}

/// Half a step's share of what the forces at t_n do while the velocity is `velocity(dof)` for `dt`.
template <int D, class Velocity>
void book(Ledger<D>& ledger, const Discretisation<D>& disc, const State<D>& state, double dt,
          double kick, double next_dt, const Velocity& velocity) {
  const bool linear = disc.linear();
  const auto push = [&](Index dof, double force) {
    Vector<D> vector = Vector<D>::Zero();
    vector[dof % D] = force;
    ledger.impulse += 0.5 * dt * vector;
    ledger.angular_impulse += 0.5 * dt * moment<D>(disc, state, linear, dof / D, vector);
  };
  for (const Load& load : disc.loads) {
    const double pressure = value(load.curve, state.time);
    for (std::size_t k = 0; k < load.dof.size(); ++k) {
      const double force = pressure * load.weight[k];
      ledger.external_work += 0.5 * dt * force * velocity(load.dof[k]);
      push(load.dof[k], force);
    }
  }
  for (const auto* still : {&disc.constraints.fixed, &disc.constraints.held})
    for (const Index dof : *still) push(dof, -state.f.data()[dof]);
  for (const auto& motion : disc.constraints.moved) {
    const double next = value(disc.constraints.curves[motion.curve], state.time + next_dt);
    const double change =
        (next - state.u.data()[motion.dof]) / next_dt - state.v.data()[motion.dof];
    const double reaction = disc.mass[motion.dof / D] * change / kick - state.f.data()[motion.dof];
    ledger.external_work += 0.5 * dt * reaction * velocity(motion.dof);
    push(motion.dof, reaction);
  }
  if (disc.has_body_force())
    for (Index q = 0; q < disc.nodes(); ++q) {
      const Vector<D> weight = disc.mass[q] * disc.body_force;
      ledger.impulse += 0.5 * dt * weight;
      ledger.angular_impulse += 0.5 * dt * moment<D>(disc, state, linear, q, weight);
    }
}

}  // namespace

template <int D>
void Ledger<D>::arrive(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const double way = state.last_dt;
  book<D>(*this, disc, state, way, 0.5 * (way + dt), dt,
          [&](Index dof) { return state.v.data()[dof]; });
  if (disc.viscosity.nonZeros() > 0)
    dissipated += 0.5 * way * state.viscous.cwiseProduct(state.v).sum();
}

template <int D>
void Ledger<D>::depart(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const double kick = 0.5 * (state.last_dt + dt);
  book<D>(*this, disc, state, dt, kick, dt,
          [&](Index dof) { return next_velocity<D>(disc, state, dt, dof); });
  if (disc.viscosity.nonZeros() > 0) {
    double power = 0.0;
    for (Index dof = 0; dof < state.v.size(); ++dof)
      power += state.viscous.data()[dof] * next_velocity<D>(disc, state, dt, dof);
    dissipated += 0.5 * dt * power;
  }
}

template <int D>
double elastic_energy(const Discretisation<D>& disc, const State<D>& state) {
  double energy = 0.0;
  for (const Region<D>& region : disc.regions)
    std::visit(
        [&](const auto& law) {
          const auto at = [&](Index s) {
            energy += disc.points.V[s] * law.energy(tensor_at<D>(state.H, s));
          };
          if (region.points.empty())
            for (Index s = 0; s < state.H.rows(); ++s) at(s);
          else
            for (const int s : region.points) at(s);
        },
        region.law);
  // ½ uᵀ S u with S·1 = 0, in differences, so that a body that has travelled far keeps its digits.
  for (Index p = 0; p < disc.stiffness.outerSize(); ++p)
    for (SparseMatrix::InnerIterator it(disc.stiffness, p); it; ++it)
      energy -= 0.25 * it.value() * (state.u.row(p) - state.u.row(it.col())).squaredNorm();
  return energy;
}

template <int D>
Balance<D> balance(const Discretisation<D>& disc, const State<D>& state, double dt) {
  const bool linear = disc.linear();
  Balance<D> result;
  for (Index q = 0; q < disc.nodes(); ++q) {
    const double m = disc.mass[q];
    Vector<D> now;
    for (int i = 0; i < D; ++i) {
      const Index dof = q * D + i;
      const double before = state.v.data()[dof];
      const double after = next_velocity<D>(disc, state, dt, dof);
      result.kinetic += 0.5 * m * before * after;
      now[i] = 0.5 * (before + after);
    }
    const Vector<D> p = m * now;
    Vector<D> x = disc.particles.X.row(q).transpose();
    if (!linear) x += state.u.row(q).transpose();
    result.linear_momentum += p;
    result.angular_momentum += moment<D>(disc, state, linear, q, p);
    result.momentum_scale += p.norm();
    result.angular_scale += x.norm() * p.norm();
    if (disc.has_body_force()) result.gravity += m * disc.body_force.dot(state.u.row(q));
  }
  result.elastic = elastic_energy(disc, state);
  return result;
}

#define TLSPH_INSTANTIATE(D)                                                    \
  template struct Ledger<D>;                                                    \
  template double elastic_energy<D>(const Discretisation<D>&, const State<D>&); \
  template Balance<D> balance<D>(const Discretisation<D>&, const State<D>&, double);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

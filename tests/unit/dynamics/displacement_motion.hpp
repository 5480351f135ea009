#pragma once
/// \file
/// The formulations with unknowns {u, v} as an equation of motion, both at the same time t: for
/// integrators that are no central difference.

#include "tlsph/dynamics/balance.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/formulations/motion.hpp"

namespace tlsph {

/// u̇ = v, v̇ = M⁻¹ f(t, u, v); a moved node follows its curve.
template <int D>
struct DisplacementMotion {
  const Discretisation<D>& body;

  using State = tlsph::State<D>;
  struct Rate {
    VectorField<D> u, v;
  };

  void rate(double t, State& state, Rate& out) const {
    state.time = t;
    for (const auto& motion : body.constraints.moved) {
      const Curve& curve = body.constraints.curves[motion.curve];
      state.u.data()[motion.dof] = value(curve, t);
      state.v.data()[motion.dof] = tlsph::rate(curve, t);
    }
    evaluate<D>(body, state);
    out.u = state.v;
    out.v = body.inverse_mass.cwiseProduct(state.f);
  }
  void add(double h, const Rate& rate, State& state) const {
    state.u += h * rate.u;
    state.v += h * rate.v;
  }
  [[nodiscard]] double energy(const State& state) const {
    return 0.5 * body.mass.dot(state.v.rowwise().squaredNorm()) + elastic_energy<D>(body, state);
  }
};
static_assert(EquationOfMotion<DisplacementMotion<1>> && EquationOfMotion<DisplacementMotion<2>>);

}  // namespace tlsph

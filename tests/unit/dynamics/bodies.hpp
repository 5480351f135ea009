#pragma once
/// \file
/// Bars and sheets of a few cells with stress points at their centres, put together by hand.

#include "tlsph/filling/lattice.hpp"
#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph::test {

inline constexpr double young = 2e6;
inline constexpr double density = 1000.0;

/// The body [0, 0.02·cells] (times [0, 0.02·cells] in 2D); nothing held.
template <int D>
Discretisation<D> cells_of(int cells, LawName law = LawName::linear_elastic) {
  constexpr double spacing = 0.02;
  Discretisation<D> body;
  body.particles = make_lattice<D>(
      Shape<D>{Box<D>{Vector<D>::Zero(), Vector<D>::Constant(spacing * cells)}}, spacing);
  body.points = cell_points<D>(body.particles);
  body.spacing = spacing;
  body.gradient = cell_gradient<D>(body.particles, body.points);
  body.divergence = body.gradient.negative_adjoint(body.points.V);
  body.mass = density * body.particles.V;
  body.inverse_mass = body.mass.cwiseInverse().replicate(1, D);
  body.regions = {{make_law<D>(law, Assumption::strain, young, 0.3), density, {}}};
  return body;
}

template <int D>
void hold(Discretisation<D>& body, Index dof) {
  body.constraints.fixed.push_back(dof);
  body.inverse_mass.data()[dof] = 0.0;
}

template <int D>
void move(Discretisation<D>& body, Index dof, const Curve& curve) {
  body.constraints.moved.push_back({dof, body.constraints.curves.size()});
  body.constraints.curves.push_back(curve);
  body.inverse_mass.data()[dof] = 0.0;
}

}  // namespace tlsph::test

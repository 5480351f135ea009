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
  Discretisation<D> disc;
  disc.particles = make_lattice<D>(
      Shape<D>{Box<D>{Vector<D>::Zero(), Vector<D>::Constant(spacing * cells)}}, spacing);
  disc.points = cell_points<D>(disc.particles);
  disc.spacing = spacing;
  disc.gradient = cell_gradient<D>(disc.particles, disc.points);
  disc.divergence = disc.gradient.negative_adjoint(disc.points.V);
  disc.mass = density * disc.particles.V;
  disc.inverse_mass = disc.mass.cwiseInverse().replicate(1, D);
  disc.regions = {{make_law<D>(law, Assumption::strain, young, 0.3), density, {}}};
  return disc;
}

template <int D>
void hold(Discretisation<D>& disc, Index dof) {
  disc.constraints.fixed.push_back(dof);
  disc.inverse_mass.data()[dof] = 0.0;
}

template <int D>
void move(Discretisation<D>& disc, Index dof, const Curve& curve) {
  disc.constraints.moved.push_back({dof, disc.constraints.curves.size()});
  disc.constraints.curves.push_back(curve);
  disc.inverse_mass.data()[dof] = 0.0;
}

}  // namespace tlsph::test

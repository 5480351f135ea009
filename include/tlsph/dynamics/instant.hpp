#pragma once
/// \file
/// What can be observed of a body at t_n: u, H and P of its state, and velocities and accelerations
/// at the same time as displacements.

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// A view: body and state must outlive it. H, P and f are those of t_n (`evaluate`), at least at
/// the nodes and points that are asked for.
template <int D>
struct Instant {
  const Discretisation<D>& body;
  const State<D>& state;
  double dt = 0.0;  ///< the coming step [s]

  [[nodiscard]] double time() const { return state.time; }
  [[nodiscard]] long step() const { return state.step; }
  [[nodiscard]] const VectorField<D>& u() const { return state.u; }  ///< N×d [m]
  [[nodiscard]] const TensorField<D>& H() const { return state.H; }  ///< M×d², ∂u/∂X
  [[nodiscard]] const TensorField<D>& P() const { return state.P; }  ///< M×d² [Pa]
  /// v_n [m/s] and a_n [m/s²] of a degree of freedom.
  [[nodiscard]] NodalMotion motion(Index dof) const { return motion_of<D>(body, state, dt, dof); }
  [[nodiscard]] VectorField<D> v() const { return field(&NodalMotion::velocity); }      ///< N×d
  [[nodiscard]] VectorField<D> a() const { return field(&NodalMotion::acceleration); }  ///< N×d

 private:
  [[nodiscard]] VectorField<D> field(double NodalMotion::*part) const {
    VectorField<D> values(body.nodes(), D);
    for (Index dof = 0; dof < values.size(); ++dof) values.data()[dof] = motion(dof).*part;
    return values;
  }
};

}  // namespace tlsph

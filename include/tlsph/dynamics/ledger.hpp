#pragma once
/// \file
/// The books of a run: energies and momenta, and what crossed the boundary. For linear forces the
/// central difference balances them exactly:
///
///     E_n = ½ v_{n−½}ᵀ M v_{n+½} + U(u_n),   E_{n+1} − E_n = ½ (f_n + f_{n+1}) · (u_{n+1} − u_n)
///
/// with f the forces that are no gradient of U: loads, reactions of moved degrees of freedom, and
/// viscous forces.

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// Angular momentum has one component in 2D and none in 1D.
template <int D>
struct Ledger {
  double external_work = 0.0;             ///< of loads and moved supports [J per thickness]
  double dissipated = 0.0;                ///< by C
  Vector<D> impulse = Vector<D>::Zero();  ///< of loads, body force and reactions [kg m/s]
  double angular_impulse = 0.0;           ///< about the origin

  /// Books the half of step n's forces that belongs to the way from n−1; after `evaluate`, n > 0.
  void arrive(const Discretisation<D>& discretisation, const State<D>& state, double dt);
  /// Books the half that belongs to the way to n+1; before `advance`.
  void depart(const Discretisation<D>& discretisation, const State<D>& state, double dt);
};

/// A sample of all books at t_n. `dt` is the coming step.
template <int D>
struct Balance {
  double kinetic = 0.0;                           ///< ½ v_{n−½}ᵀ M v_{n+½}
  double elastic = 0.0;                           ///< Σ V Ψ + ½ uᵀ S u
  double gravity = 0.0;                           ///< work of the body force since t = 0, Σ m g·u
  Vector<D> linear_momentum = Vector<D>::Zero();  ///< Σ m v_n
  double angular_momentum = 0.0;  ///< Σ m x × v_n (X × v_n for linear elasticity)
  double momentum_scale = 0.0;    ///< Σ m |v_n|
  double angular_scale = 0.0;     ///< Σ m |x| |v_n|
};
template <int D>
[[nodiscard]] Balance<D> balance(const Discretisation<D>& discretisation, const State<D>& state,
                                 double dt);

/// Σ V Ψ + ½ uᵀ S u [J per thickness] at the state's u and H.
template <int D>
[[nodiscard]] double elastic_energy(const Discretisation<D>& discretisation, const State<D>& state);

}  // namespace tlsph

#pragma once
/// \file
/// The books of a run: energies and momenta, and what crossed the boundary. For linear forces the
/// central difference balances them exactly:
///
///     E_n = ½ v_{n−½}ᵀ M v_{n+½} + U(u_n),   E_{n+1} − E_n = ½ (f_n + f_{n+1}) · (u_{n+1} − u_n)
///
/// with f the forces that are no gradient of U: loads, reactions of moved degrees of freedom, and
/// viscous forces. Where the step changes at t_n, v_{n+½} of the energy is what the step before
/// would have made of it, and momenta are those of v_n, a half of the step before after v_{n−½}.
/// E_n is ½ v_nᵀ M v_n + U less ⅛ Δt² aᵀ M a: it stays what it is when motion above the critical
/// step grows beyond all bounds, and the two grow.

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// What acts at time t_n on the nodes where loads, supports and moved edges are, gathered by a
/// sweep (dynamics/sweep.hpp) as it passes them.
template <int D>
struct BoundaryForces {
  std::vector<Index> nodes;    ///< ascending
  VectorField<D> f;            ///< of those: total force, reactions excluded [N per thickness]
  VectorField<D> u;            ///< displacement at t_n [m]
  VectorField<D> v;            ///< velocity at t_{n−½} [m/s]
  double viscous_power = 0.0;  ///< Σ C v · v_{n−½} over the body [W]
  double viscous_power_after = 0.0;  ///< Σ C v · v_{n+½}
  double largest_speed = 0.0;        ///< max |v_{n+½}| of all components over the body [m/s]
  Vector<D> moment_of_mass = Vector<D>::Zero();  ///< Σ m x, only with a body force in 2D [kg m]
  /// Rows above, times d plus component, of the degrees of freedom of each load and of the
  /// constraints, in their order.
  std::vector<std::vector<Index>> loads;
  std::vector<double> load_values;  ///< of the loads' curves at t_n
  std::vector<Index> fixed, held, moved;

  explicit BoundaryForces(const Discretisation<D>& discretisation);
};

/// Σ m x about the origin, positions of the reference configuration for linear elasticity [kg m].
template <int D>
[[nodiscard]] Vector<D> moment_of_mass(const Discretisation<D>& discretisation,
                                       const VectorField<D>& u);

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
  /// Books both halves of step n from what a sweep of it gathered, `after` the step to t_n + dt;
  /// the first one only unless it has `arrived` already or there is none, at n = 0.
  void book(const Discretisation<D>& discretisation, const BoundaryForces<D>& forces,
            const State<D>& after, double time, double way, double dt, bool arrived);
};

/// A sample of all books at t_n. `dt` is the coming step.
template <int D>
struct Balance {
  double kinetic = 0.0;     ///< ½ v_{n−½}ᵀ M (v_{n−½} + Δt_{n−1} a_n)
  double ripple = 0.0;      ///< ½ v_nᵀ M v_n less `kinetic`, never negative
  double elastic = 0.0;     ///< Σ V Ψ + ½ uᵀ S u
  double dissipated = 0.0;  ///< Σ V × what laws with a memory have lost since t = 0
  double gravity = 0.0;     ///< work of the body force since t = 0, Σ m g·u
  Vector<D> linear_momentum = Vector<D>::Zero();  ///< Σ m v_n
  double angular_momentum = 0.0;  ///< Σ m x × v_n (X × v_n for linear elasticity)
  double momentum_scale = 0.0;    ///< Σ m |v_n|
  double angular_scale = 0.0;     ///< Σ m |x| |v_n|
};
template <int D>
[[nodiscard]] Balance<D> balance(const Discretisation<D>& discretisation, const State<D>& state,
                                 double dt);

/// Σ V Ψ + ½ uᵀ S u [J per thickness] at the state's u, H and memory.
template <int D>
[[nodiscard]] double elastic_energy(const Discretisation<D>& discretisation, const State<D>& state);
/// Σ V × what laws with a memory have lost since t = 0 [J per thickness], at the state's memory.
template <int D>
[[nodiscard]] double dissipated_energy(const Discretisation<D>& discretisation,
                                       const State<D>& state);

}  // namespace tlsph

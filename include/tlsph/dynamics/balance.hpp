#pragma once
/// \file
/// Energy and momenta of a body, and what crossed its boundary. For linear forces the central
/// difference balances them exactly:
///
///     E_n = ½ v_{n−½}ᵀ M v_{n+½} + U(u_n),   E_{n+1} − E_n = ½ (f_n + f_{n+1}) · (u_{n+1} − u_n)
///
/// with f the forces that are no gradient of U: loads, reactions of moved degrees of freedom, and
/// viscous forces. Where the step changes at t_n, v_{n+½} of the energy is what the step before
/// would have made of it, and momenta are those of v_n, a half of the step before after v_{n−½}.
/// E_n is ½ v_nᵀ M v_n + U less ⅛ Δt² aᵀ M a: it stays what it is when motion above the critical
/// step grows without bound, and the two grow.

#include <vector>

#include "tlsph/dynamics/state.hpp"

namespace tlsph {

/// What acts at time t_n on the nodes with loads, supports and moved edges. A sweep
/// (sweep/sweep.hpp) fills it on its way; `gather` does without one.
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
  std::vector<Index> fixed, held, moved, reactions;
  std::vector<double> reaction_values;  ///< where they are made of stresses: `gather` only [N]

  explicit BoundaryForces(const Discretisation<D>& discretisation);
  /// Fills all but `largest_speed`. Takes nothing from the heap.
  void gather(const Instant<D>& now);
};

/// Σ m x about the origin, positions of the reference configuration for linear elasticity [kg m].
template <int D>
[[nodiscard]] Vector<D> moment_of_mass(const Discretisation<D>& discretisation,
                                       const VectorField<D>& u);

/// The steps before and after t_n.
struct Steps {
  double before = 0.0, after = 0.0;  ///< of the whole steps [s]
  bool before_added = false;         ///< by `add_before`, or there is none
};

/// What loads, supports and viscosity have done since t = 0. The forces of step n act during half
/// of the step before and half of the step after it. Angular momentum has one component in 2D and
/// none in 1D.
template <int D>
struct WorkAndImpulse {
  double external_work = 0.0;             ///< of loads and moved supports [J per thickness]
  double dissipated = 0.0;                ///< by C
  Vector<D> impulse = Vector<D>::Zero();  ///< of loads, body force and reactions [kg m/s]
  double angular_impulse = 0.0;           ///< about the origin

  /// Adds what `forces`, gathered at `now`, did in the half step before it; n > 0.
  void add_before(const BoundaryForces<D>& forces, const Instant<D>& now);
  /// Adds what they do in the half step after it; before `advance`.
  void add_after(const BoundaryForces<D>& forces, const Instant<D>& now);
  /// Adds what forces that a sweep gathered on its way to the state `after` did.
  void add_step(const Discretisation<D>& discretisation, const BoundaryForces<D>& forces,
                const State<D>& after, const Steps& steps);

  /// Calls `visit(name, value)` for each of the above.
  template <class Visit>
  void visit(const Visit& visit) {
    visit("external_work", external_work);
    visit("dissipated", dissipated);
    visit("impulse", impulse);
    visit("angular_impulse", angular_impulse);
  }
};

/// Energy and momenta at t_n.
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
[[nodiscard]] Balance<D> balance(const Instant<D>& now);

/// Σ V Ψ + ½ uᵀ S u [J per thickness] at the state's u, H and memory.
template <int D>
[[nodiscard]] double elastic_energy(const Discretisation<D>& discretisation, const State<D>& state);
/// Σ V × what laws with a memory have lost since t = 0 [J per thickness], at the state's memory.
template <int D>
[[nodiscard]] double dissipated_energy(const Discretisation<D>& discretisation,
                                       const State<D>& state);

}  // namespace tlsph

#pragma once
/// \file
/// What changes during a run. Position, half-step velocity and the past of laws with a memory are
/// the state proper; the rest is recomputed from them, so that a run goes on bit-identically from
/// {step, time, last_dt, u, v, past}.

#include <string>
#include <vector>

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

/// What material points remember, M×m; no columns where no law has a memory.
using MemoryField = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <int D>
struct State {
  long step = 0;
  double time = 0.0;     ///< t_n [s]
  double last_dt = 0.0;  ///< t_n − t_{n−1} [s]; equal to the coming step at n = 0
  VectorField<D> u;      ///< displacement at t_n [m]
  VectorField<D> v;      ///< velocity at t_{n−½} [m/s]
  MemoryField past;      ///< memory of the laws at t_{n−1}

  TensorField<D> H;        ///< displacement gradient at t_n
  TensorField<D> P;        ///< first Piola–Kirchhoff stress at t_n [Pa]
  MemoryField memory;      ///< of the laws at t_n
  VectorField<D> f;        ///< total force at t_n, reactions excluded [N per thickness]
  VectorField<D> viscous;  ///< C v, empty without viscosity
  std::vector<double> signals;
  typename GhostGradient<D>::Workspace ghosts;
};

/// The past of a sudden change of an evaluated state at a material point.
template <int D>
[[nodiscard]] Past present(const State<D>& state, Index point) {
  return {state.memory.data() + point * state.memory.cols(), 0.0};
}

/// The state at t = 0 with u and v(0) given; v is set to v_{−½} = v(0) − ½ Δt a(0) by `start`.
/// Material is virgin.
template <int D>
[[nodiscard]] State<D> make_state(const Discretisation<D>& discretisation, VectorField<D> u,
                                  VectorField<D> v);

/// H, P, memory and f at the state's u, v, past and time. Throws NumericalError, naming time and
/// material point, when det F ≤ 0 or a stress is not finite. Takes nothing from the heap.
template <int D>
void evaluate(const Discretisation<D>& discretisation, State<D>& state);

/// The same without a look at the result, which may hold what is not finite.
template <int D>
void evaluate_unchecked(const Discretisation<D>& discretisation, State<D>& state);

/// Throws the NumericalError of a state without stress: its time, and the material point that is
/// worst.
template <int D>
[[noreturn]] void report_failure(const Discretisation<D>& discretisation, const State<D>& state);

/// v_{n+½} [m/s] of one degree of freedom if the coming step is `dt`; at a moved one, what takes it
/// to its prescribed place at t_n + dt.
template <int D>
[[nodiscard]] double next_velocity(const Discretisation<D>& discretisation, const State<D>& state,
                                   double dt, Index dof);

/// Throws a NumericalError: `what`, the state's time, and the material point that is deformed most.
/// Needs the H of the state.
template <int D>
[[noreturn]] void report_loss(const Discretisation<D>& discretisation, const State<D>& state,
                              const std::string& what);

/// Velocity at t_n [m/s] and acceleration [m/s²] of one degree of freedom.
struct NodalMotion {
  double velocity = 0.0, acceleration = 0.0;
};

/// What can be observed of a body at t_n: u, H and P of its state, and velocities and accelerations
/// at the same time as displacements. A view: body and state must outlive it. H, P and f are those
/// of t_n (`evaluate`), at least at the nodes and points that are asked for.
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
  /// a_n = (v_{n+½} − v_{n−½}) / ½(Δt_{n−1} + Δt_n) and v_n = v_{n−½} + ½ Δt_{n−1} a_n.
  [[nodiscard]] NodalMotion motion(Index dof) const;
  [[nodiscard]] VectorField<D> v() const { return field(&NodalMotion::velocity); }      ///< N×d
  [[nodiscard]] VectorField<D> a() const { return field(&NodalMotion::acceleration); }  ///< N×d

 private:
  [[nodiscard]] VectorField<D> field(double NodalMotion::*part) const {
    VectorField<D> values(body.nodes(), D);
    for (Index dof = 0; dof < values.size(); ++dof) values.data()[dof] = motion(dof).*part;
    return values;
  }
};

/// Turns v(0), as `make_state` left it, into v_{−½}. Needs `evaluate` before.
template <int D>
void start(const Discretisation<D>& discretisation, State<D>& state, double dt);

/// One step of the central difference: v_{n+½} = v_{n−½} + ½(Δt_{n−1} + Δt) a_n, u_{n+1} = u_n +
/// Δt v_{n+½}, to `next_time` = t_n + dt. Needs `evaluate` before; leaves H, P and f behind at t_n,
/// whose memory becomes the past.
template <int D>
void advance(const Discretisation<D>& discretisation, State<D>& state, double dt, double next_time);

}  // namespace tlsph

#include "tlsph/dynamics/state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tlsph/core/error.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/dynamics/measures.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/uniaxial.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

template <int D>
void evaluate_signals(const Discretisation<D>& body, double time, std::vector<double>& values) {
  for (std::size_t k = 0; k < body.signals.size(); ++k) {
    const Signal& signal = body.signals[k];
    const double load = value(signal.curve, time);
    values[k] = signal.kind == Signal::Kind::value
                    ? load
                    : uniaxial_gradient<D>(body.regions[signal.region].law, load);
  }
}

void add_terms(const std::vector<SignalTerm>& terms, const std::vector<double>& values,
               double* field) {
  for (const SignalTerm& term : terms) field[term.slot] += term.weight * values[term.signal];
}

/// P = ∂Ψ/∂F over a region, and the memory there; the sum of all P_11 turns NaN or infinite as soon
/// as one of them does. A polynomial law stays finite beyond its range, so points there add NaN.
template <int D>
double apply_law(const Region<D>& region, State<D>& state) {
  const Index remembered = state.past.cols();
  const double dt = state.step == 0 ? 0.0 : state.last_dt;
  return std::visit(
      [&](const auto& law) {
        const auto at = [&](Index s) {
          const Tensor<D> H = tensor_at<D>(state.H, s);
          const Tensor<D> stress = law.at({state.past.data() + s * remembered, dt})
                                       .pk1(H, state.memory.data() + s * remembered);
          Eigen::Map<Tensor<D>>(state.P.data() + s * D * D) = stress;
          return law.margin(H) > 0.0 ? stress(0, 0) : std::numeric_limits<double>::quiet_NaN();
        };
        return sum_rows(region.size(state.H.rows()), [&](Index k) { return at(region.point(k)); });
      },
      region.law);
}

/// H and P of the state; not finite where a stress is not.
template <int D>
double stresses(const Discretisation<D>& body, State<D>& state) {
  evaluate_signals(body, state.time, state.signals);
  if (body.ghosts)
    body.ghosts->apply(state.u, state.signals, state.H, state.ghosts);
  else
    body.gradient.gradient(state.u, state.H);
  add_terms(body.gradient_terms, state.signals, state.H.data());

  double finite = 0.0;
  for (const Region<D>& region : body.regions) finite += apply_law(region, state);
  for (const SignalTerm& term : body.stress_values)
    state.P.data()[term.slot] =
        term.signal == no_signal ? 0.0 : term.weight * state.signals[term.signal];
  return finite;
}

/// f of the state from its P.
template <int D>
void forces(const Discretisation<D>& body, State<D>& state) {
  body.divergence.divergence(state.P, state.f);
  add_terms(body.force_terms, state.signals, state.f.data());
  if (body.adjoint)
    for (const Load& load : body.loads) {
      const double pressure = value(load.curve, state.time);
      for (std::size_t k = 0; k < load.dof.size(); ++k)
        state.f.data()[load.dof[k]] += pressure * load.weight[k];
    }
  if (body.has_body_force()) state.f.noalias() += body.mass * body.body_force.transpose();
  subtract_stabiliser<D>(body, state.u, state.f);
  if (body.viscosity.nonZeros() > 0) {
    multiply_differences<D>(body.viscosity, state.v, state.viscous);
    state.f -= state.viscous;
  }
}

/// "(0.1, 0.2)" of a material point.
template <int D>
std::string place_of(const Discretisation<D>& body, Index point) {
  const auto X = body.points.X.row(point);
  return fmt::format("({:.6g})", fmt::join(X.begin(), X.end(), ", "));
}

}  // namespace

template <int D>
void report_loss(const Discretisation<D>& body, const State<D>& state, const std::string& what) {
  Index worst = 0;
  double most = -1.0;
  for (Index s = 0; s < state.H.rows(); ++s) {
    const Tensor<D> H = tensor_at<D>(state.H, s);
    // ‖H‖ where the material is torn, ‖H‖ ‖F⁻¹‖ where it is crushed.
    const double size = H.norm() * std::max(1.0, (Tensor<D>::Identity() + H).inverse().norm());
    if (size <= most) continue;
    worst = s;
    most = size;
    if (!std::isfinite(size)) break;
  }
  throw NumericalError(
      fmt::format("{} at t = {:.6e} s, step {}; material point {} at {} m is deformed most", what,
                  state.time, state.step, worst, place_of<D>(body, worst)),
      state.time, static_cast<long>(worst));
}

template <int D>
void report_failure(const Discretisation<D>& body, const State<D>& state) {
  Index worst = 0;
  double smallest = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Region<D>& region, Index s) {
    const double here = margin<D>(region.law, tensor_at<D>(state.H, s));
    const bool lost = !std::isfinite(here) || !state.P.row(s).allFinite();
    if (!std::isfinite(smallest) && smallest < 0.0) return;  // the first one that is lost
    if (!lost && !(here < smallest)) return;
    worst = s;
    smallest = lost ? -std::numeric_limits<double>::infinity() : here;
  };
  for (const Region<D>& region : body.regions)
    for (Index k = 0; k < region.size(state.H.rows()); ++k) look_at(region, region.point(k));
  const AnyLaw<D>& law = body.regions[region_of<D>(body, worst)].law;
  const Tensor<D> H = tensor_at<D>(state.H, worst);
  const double J = 1 + volume_change<D>(H);
  const bool beyond = J > 0.0 && !(margin<D>(law, H) > 0.0);
  throw NumericalError(
      fmt::format("{} at t = {:.6e} s, step {}: material point {} at {} m has det F = {:.3g} {}",
                  beyond ? "the range of the law ended" : "deformation lost", state.time,
                  state.step, worst, place_of<D>(body, worst), J,
                  beyond
                      ? fmt::format("and is outside the law's range, {}", range<D>(law))
                      : "or a stress that is not finite; a smaller time.safety, a finer spacing, "
                        "a stabiliser or a gentler load may help"),
      state.time, static_cast<long>(worst));
}

template <int D>
State<D> make_state(const Discretisation<D>& body, VectorField<D> u, VectorField<D> v) {
  State<D> state;
  state.u = std::move(u);
  state.v = std::move(v);
  for (const Index dof : body.constraints.fixed) {
    state.u.data()[dof] = 0.0;
    state.v.data()[dof] = 0.0;
  }
  for (const Index dof : body.constraints.held) state.v.data()[dof] = 0.0;
  for (const auto& motion : body.constraints.moved) {
    const Curve& curve = body.constraints.curves[motion.curve];
    state.u.data()[motion.dof] = value(curve, 0.0);
    state.v.data()[motion.dof] = rate(curve, 0.0);
  }
  const Index M = body.points.size();
  state.H = TensorField<D>::Zero(M, D * D);
  state.P = TensorField<D>::Zero(M, D * D);
  state.past = state.memory = MemoryField::Zero(M, body.memory());
  state.f = VectorField<D>::Zero(body.nodes(), D);
  if (body.viscosity.nonZeros() > 0) state.viscous = VectorField<D>::Zero(body.nodes(), D);
  state.signals.assign(body.signals.size(), 0.0);
  if (body.ghosts) state.ghosts = body.ghosts->workspace();
  return state;
}

template <int D>
void evaluate(const Discretisation<D>& body, State<D>& state) {
  if (!std::isfinite(stresses(body, state))) report_failure(body, state);
  forces(body, state);
}

template <int D>
void evaluate_unchecked(const Discretisation<D>& body, State<D>& state) {
  (void)stresses(body, state);
  forces(body, state);
}

template <int D>
double next_velocity(const Discretisation<D>& body, const State<D>& state, double dt, Index dof) {
  const double inverse_mass = body.inverse_mass.data()[dof];
  if (inverse_mass == 0.0) {
    const auto& moved = body.constraints.moved;
    const auto motion = std::ranges::lower_bound(moved, dof, {}, &Constraints::Motion::dof);
    if (motion == moved.end() || motion->dof != dof) return 0.0;
    return (value(body.constraints.curves[motion->curve], state.time + dt) - state.u.data()[dof]) /
           dt;
  }
  return state.v.data()[dof] + 0.5 * (state.last_dt + dt) * inverse_mass * state.f.data()[dof];
}

template <int D>
NodalMotion Instant<D>::motion(Index dof) const {
  const double before = state.v.data()[dof];
  const double after = next_velocity<D>(body, state, dt, dof);
  const double acceleration = (after - before) / (0.5 * (state.last_dt + dt));
  return {before + 0.5 * state.last_dt * acceleration, acceleration};
}

template <int D>
void start(const Discretisation<D>& body, State<D>& state, double dt) {
  state.last_dt = dt;
  state.v -= 0.5 * dt * body.inverse_mass.cwiseProduct(state.f);
}

template <int D>
void advance(const Discretisation<D>& body, State<D>& state, double dt, double next_time) {
  const double kick = 0.5 * (state.last_dt + dt);
  double* u = state.u.data();
  double* v = state.v.data();
  const double* f = state.f.data();
  const double* inverse_mass = body.inverse_mass.data();
  for_rows(body.nodes(), [=](Index q) {
    for (Index k = q * D; k < (q + 1) * D; ++k) {
      v[k] += kick * inverse_mass[k] * f[k];
      u[k] += dt * v[k];
    }
  });
  state.past.swap(state.memory);
  ++state.step;
  state.time = next_time;
  state.last_dt = dt;
  for (const auto& motion : body.constraints.moved) {
    const double next = value(body.constraints.curves[motion.curve], state.time);
    // u already holds u_n + Δt v_n−½ here; v_n−½ is still in v, its inverse mass being zero.
    v[motion.dof] = (next - (u[motion.dof] - dt * v[motion.dof])) / dt;
    u[motion.dof] = next;
  }
}

#define TLSPH_INSTANTIATE(D)                                                                   \
  template State<D> make_state<D>(const Discretisation<D>&, VectorField<D>, VectorField<D>);   \
  template void evaluate<D>(const Discretisation<D>&, State<D>&);                              \
  template void report_failure<D>(const Discretisation<D>&, const State<D>&);                  \
  template void report_loss<D>(const Discretisation<D>&, const State<D>&, const std::string&); \
  template void evaluate_unchecked<D>(const Discretisation<D>&, State<D>&);                    \
  template double next_velocity<D>(const Discretisation<D>&, const State<D>&, double, Index);  \
  template struct Instant<D>;                                                                  \
  template void start<D>(const Discretisation<D>&, State<D>&, double);                         \
  template void advance<D>(const Discretisation<D>&, State<D>&, double, double);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sample.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/stepping/linearised_forces.hpp"
#include "tlsph/stepping/stepper.hpp"

namespace tlsph {
namespace {

constexpr double displacement = 1e-10;  ///< of the perturbation [Δ]
constexpr double velocity = 1e-3;       ///< of the run that keeps books [c_p]
constexpr long usual_steps = 1000;
constexpr long most_steps = 20000;
constexpr long book_steps = 300;
constexpr long rest_steps = 200;
constexpr double linear_until = 1e7;  ///< times the perturbation: strains of about a thousandth
constexpr double overflow = 1e13;

/// Uniform in [−1, 1) at every degree of freedom that is free.
template <int D>
VectorField<D> random_field(const Discretisation<D>& body) {
  std::mt19937_64 bits(7);
  VectorField<D> field(body.nodes(), D);
  for (Index k = 0; k < field.size(); ++k) {
    const double value = std::ldexp(static_cast<double>(bits() >> 11), -52) - 1.0;
    field.data()[k] = body.inverse_mass.data()[k] == 0.0 ? 0.0 : value;
  }
  return field;
}

/// √(xᵀ M x).
template <int D>
double norm(const Discretisation<D>& body, const VectorField<D>& x) {
  return std::sqrt(body.mass.dot(x.rowwise().squaredNorm()));
}

/// Steps from u and v about the uniform state, whose forces are balanced.
template <int D>
Stepper<D> balanced(const Sample<D>& sample, const VectorField<D>& u, const VectorField<D>& v,
                    double dt) {
  return {sample.body,
          u,
          v,
          {.step = dt,
           .balance_every = 0,
           .evaluate = [&f = sample.state.f](const Discretisation<D>& body, State<D>& state) {
             evaluate<D>(body, state);
             state.f -= f;
           }}};
}

/// Kinetic and elastic energy, the dead loads' potential included, of an evaluated state.
template <int D>
double energy_of(const Sample<D>& sample, const State<D>& state, double dt) {
  const Discretisation<D>& body = sample.body;
  const VectorField<D> next = state.v + dt * body.inverse_mass.cwiseProduct(state.f);
  const double kinetic = 0.5 * body.mass.dot(state.v.cwiseProduct(next).rowwise().sum());
  return kinetic + elastic_energy<D>(body, state) +
         sample.state.f.cwiseProduct(state.u - sample.state.u).sum();
}

long steps_to_see(double growth) {
  if (!(growth > 0.0) || growth * static_cast<double>(most_steps) < 15.0) return usual_steps;
  return std::clamp(static_cast<long>(35.0 / growth), 200L, most_steps);
}

/// Slope of ln(amplitude) over the steps while it grows and small displacements stay small.
double growth_of(const std::vector<double>& amplitude) {
  double largest = 0.0;
  std::vector<double> step;
  for (std::size_t n = 0; n < amplitude.size(); ++n) {
    step.push_back(static_cast<double>(n));
    largest = std::max(largest, amplitude[n]);
  }
  if (largest < 10.0) return 0.0;
  // The last three decades, where the fastest mode has left the others behind; more of the run if
  // that takes it less than three steps.
  const double high = std::min(linear_until, 0.9 * largest);
  const double late = growth_rate(step, amplitude, std::max(1.5, 1e-3 * high), high);
  return std::isnan(late) ? growth_rate(step, amplitude, 1.5, high) : late;
}

/// Takes the translations and the rotation out of a velocity field.
template <int D>
void remove_rigid_motion(const Discretisation<D>& body, VectorField<D>& v) {
  const auto remove = [&](const VectorField<D>& mode) {
    const double share = body.mass.dot(mode.cwiseProduct(v).rowwise().sum()) /
                         body.mass.dot(mode.rowwise().squaredNorm());
    v -= share * mode;
  };
  for (int i = 0; i < D; ++i) {
    VectorField<D> mode = VectorField<D>::Zero(body.nodes(), D);
    mode.col(i).setOnes();
    remove(mode);
  }
  if constexpr (D == 2) {
    const Vector<2> centre = body.particles.X.transpose() * body.mass / body.mass.sum();
    VectorField<2> mode(body.nodes(), 2);
    mode.col(0) = -(body.particles.X.col(1).array() - centre[1]);
    mode.col(1) = body.particles.X.col(0).array() - centre[0];
    remove(mode);
  }
}

}  // namespace

template <int D>
PerturbedRun perturbed_run(const Sample<D>& sample, const StateSpectrum& spectrum, double dt,
                           const std::string& label) {
  const Discretisation<D>& body = sample.body;
  PerturbedRun run;
  run.label = label;
  run.ratio = dt / spectrum.critical();
  if (body.viscosity.nonZeros() == 0) run.expected = growth_per_step(spectrum.squares, dt);
  const VectorField<D> push = displacement * body.spacing * random_field<D>(body);
  // √(2E₀) of the perturbation if all of it were in the fastest mode.
  const double unit = 2.0 / spectrum.limit * norm<D>(body, push);
  const double growth = dt > spectrum.limit ? std::max(run.expected, 0.02) : run.expected;
  const long last = steps_to_see(growth);
  std::vector<double> amplitude;
  try {
    Stepper<D> stepper = balanced<D>(sample, sample.state.u + push, sample.state.v, dt);
    for (run.steps = 0; run.steps < last; ++run.steps) {
      stepper.step();
      amplitude.push_back(norm<D>(body, stepper.state().v) / unit);
      if (!(amplitude.back() < overflow)) break;
    }
    stepper.evaluate();
  } catch (const NumericalError&) {
    run.lost_at = static_cast<long>(amplitude.size());
  }
  if (!amplitude.empty()) run.amplitude = *std::ranges::max_element(amplitude);
  run.seen = growth_of(amplitude);
  return run;
}

template <int D>
double energy_drift(const Sample<D>& sample, double dt) {
  const Discretisation<D>& body = sample.body;
  const VectorField<D> v = velocity * body.wave_speed() * random_field<D>(body);
  Stepper<D> stepper = balanced<D>(sample, sample.state.u, v, dt);
  const double first = 0.5 * std::pow(norm<D>(body, v), 2);
  const bool damped = body.viscosity.nonZeros() > 0;
  double start = 0.0;
  double drift = 0.0;
  for (long step = 0; step <= book_steps; ++step) {
    if (step % 10 == 0) {
      stepper.evaluate();
      const double energy = energy_of<D>(sample, stepper.state(), dt);
      if (step == 0) start = energy;
      drift = std::max(drift, damped ? energy - start : std::abs(energy - start));
    }
    stepper.step();
  }
  return drift / first;
}

template <int D>
double drift_at_rest(const Sample<D>& sample, double dt) {
  const Discretisation<D>& body = sample.body;
  double largest = 0.0;
  try {
    Stepper<D> stepper(body, sample.state.u, sample.state.v,
                       {.step = dt, .sweep = false, .balance_every = 0});
    for (long step = 0; step < rest_steps; ++step) {
      stepper.step();
      largest = std::max(largest, stepper.state().v.rowwise().norm().maxCoeff());
    }
  } catch (const NumericalError&) {
    return std::numeric_limits<double>::infinity();
  }
  return largest / body.wave_speed();
}

/// The mode of least energy that is no rigid motion, as a velocity of unit norm.
template <int D>
VectorField<D> lowest_motion(const Sample<D>& sample) {
  const Discretisation<D>& body = sample.body;
  constexpr Index rigid = D * (D + 1) / 2;
  LinearisedForces<D> forces(body, sample.state);
  const Modes modes = lowest_modes(forces.dynamical_matrix(), rigid + 1);
  // Without energy they come in any mixture: one of them is left when rigid motion is taken off.
  VectorField<D> best = VectorField<D>::Zero(body.nodes(), D);
  for (Index k = 0; k < modes.vectors.cols(); ++k) {
    VectorField<D> v =
        Eigen::Map<const VectorField<D>>(modes.vectors.col(k).data(), body.nodes(), D);
    v = v.cwiseProduct(body.inverse_mass.cwiseSqrt());
    remove_rigid_motion<D>(body, v);
    if (norm<D>(body, v) > norm<D>(body, best)) best = v;
  }
  return best / norm<D>(body, best);
}

template <int D>
double free_excursion(const Sample<D>& sample, double dt, double omega) {
  const Discretisation<D>& body = sample.body;
  const VectorField<D> v =
      displacement * body.wave_speed() * std::sqrt(body.mass.sum()) * lowest_motion<D>(sample);
  Stepper<D> stepper = balanced<D>(sample, sample.state.u, v, dt);
  const double unit = norm<D>(body, v) / omega;
  const auto last = static_cast<long>(std::ceil(4.0 * std::numbers::pi / (omega * dt)));
  double largest = 0.0;
  for (long step = 0; step < last; ++step) {
    stepper.step();
    largest = std::max(largest, norm<D>(body, stepper.state().u - sample.state.u) / unit);
  }
  return largest;
}

#define TLSPH_INSTANTIATE(D)                                                             \
  template PerturbedRun perturbed_run<D>(const Sample<D>&, const StateSpectrum&, double, \
                                         const std::string&);                            \
  template double energy_drift<D>(const Sample<D>&, double);                             \
  template double drift_at_rest<D>(const Sample<D>&, double);                            \
  template double free_excursion<D>(const Sample<D>&, double, double);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

// A wave of 10 % strain in a Neo-Hookean bar against the theory of characteristics, and a small one
// against linear elasticity.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "list.hpp"
#include "samples.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/materials/uniaxial.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/stepping/critical_step.hpp"
#include "validation_bar.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

/// A wave that runs one way through a nonlinear bar at rest, exactly, until it breaks.
/// With c(H) = √((dP/dH)/ρ) and m(H) = ∫₀ᴴ c dH', the bar ρ u_tt = P_X carries v − m unchanged
/// along dX/dt = c and v + m along dX/dt = −c. Where nothing comes back v = −m, and each state
/// leaves the end X = 0 with the speed c of its own: P(X, τ + X/c) = p(τ).
class SimpleWave {
 public:
  /// Load p(τ) [Pa] at X = 0, followed for τ in [0, duration] s; density in kg/m³.
  SimpleWave(AnyLaw<1> law, double density, Curve load, double duration)
      : law_(law), density_(density), load_(std::move(load)), duration_(duration) {}

  /// c [m/s] at the displacement gradient H.
  [[nodiscard]] double speed(double H) const {
    return std::sqrt(tangent<1>(law_, Tensor<1>::Constant(H))(0, 0) / density_);
  }
  /// m [m/s].
  [[nodiscard]] double invariant(double H) const;
  /// H with m(H) = value.
  [[nodiscard]] double gradient_of(double value) const;
  /// H = P⁻¹(traction).
  [[nodiscard]] double gradient_under(double traction) const {
    return uniaxial_gradient<1>(law_, traction);
  }
  [[nodiscard]] double stress(double H) const { return pk1<1>(law_, Tensor<1>::Constant(H))(0, 0); }

  /// Where two states meet first and the wave breaks [m]: the least of c²/(dc/dτ).
  [[nodiscard]] double breaking_distance() const;
  /// Columns `stress` [Pa] and `velocity` [m/s] at X [m] before the wave breaks, at the times when
  /// evenly loaded states arrive.
  [[nodiscard]] History history(double X) const;

 private:
  static constexpr int states = 4000;  // of the load that are followed

  AnyLaw<1> law_;
  double density_;
  Curve load_;
  double duration_;
};

double SimpleWave::invariant(double H) const {
  constexpr int panels = 64;  // of Simpson's rule: c is smooth, the rest is round-off
  const double width = H / panels;
  double sum = 0.0;
  for (int k = 0; k < panels; ++k)
    sum += speed(k * width) + 4.0 * speed((k + 0.5) * width) + speed((k + 1) * width);
  return sum * width / 6.0;
}

double SimpleWave::gradient_of(double value) const {
  double H = value / speed(0.0);
  for (int k = 0; k < 50; ++k) {
    const double step = (invariant(H) - value) / speed(H);
    H -= step;
    if (std::abs(step) < 1e-14) break;
  }
  return H;
}

double SimpleWave::breaking_distance() const {
  double distance = std::numeric_limits<double>::infinity();
  const double step = duration_ / states;
  for (int k = 0; k < states; ++k) {
    const double before = speed(gradient_under(value(load_, k * step)));
    const double after = speed(gradient_under(value(load_, (k + 1) * step)));
    // Sent out a step apart, the second catches up after this way.
    if (after > before) distance = std::min(distance, step * before * after / (after - before));
  }
  return distance;
}

History SimpleWave::history(double X) const {
  History result;
  result.names = {"stress", "velocity"};
  result.values.resize(2);
  for (int k = 0; k <= states; ++k) {
    const double sent = k * duration_ / states;
    const double H = gradient_under(value(load_, sent));
    result.time.push_back(sent + X / speed(H));
    result.values[0].push_back(stress(H));
    result.values[1].push_back(-invariant(H));
  }
  return result;
}

constexpr PulseCurve load{-35e9, 5e-6, 2.5e-6};
constexpr double crest_time = 3.0 * load.rise + load.duration / 2.0;  // of the load [s]
using validation_bar::formulations;

SimpleWave exact_wave() {
  return {make_law<1>(LawName::neo_hookean, Assumption::strain, validation_bar::young,
                      validation_bar::poisson),
          validation_bar::density, load, 2.0 * crest_time};
}

/// When the load first reaches `share` of its crest [s].
double time_of(double share) {
  double before = 0.0;
  double after = crest_time;
  while (after - before > 1e-15) {
    const double middle = 0.5 * (before + after);
    (value(load, middle) > share * value(load, crest_time) ? before : after) = middle;
  }
  return before;
}

/// Nothing that the fixed end sends back is at 0.10 m before: the front reaches the end with c(0)
/// and comes back through a body that is nowhere stiffer than under the crest.
double first_reflection(const SimpleWave& exact) {
  return validation_bar::length / exact.speed(0.0) +
         (validation_bar::length - 0.10) /
             exact.speed(exact.gradient_under(value(load, crest_time)));
}

/// Relative L2 error of samples against an exact history, until `end`.
double error_against(const History& exact, std::size_t column, double end, const Samples& samples) {
  std::vector<double> inside, at;
  for (std::size_t k = 0; k < samples.time.size(); ++k)
    if (samples.time[k] >= exact.time.front() && samples.time[k] <= end) {
      at.push_back(samples.time[k]);
      inside.push_back(samples.values[k]);
    }
  return relative_error({at, inside}, resample(exact.time, exact.values[column], at));
}

/// The largest |v + m(H)| at 0.10 m before anything comes back, over the largest |m|.
double invariant_error(const SimpleWave& exact, const CaseScene& scene) {
  const auto& time = scene.history.time;
  const auto v = scene.probe("p3.velocity_x");
  const auto F = scene.probe("p3.deformation_gradient_xx");
  const double back = first_reflection(exact);
  double largest = 0.0;
  double error = 0.0;
  for (std::size_t k = 0; k < time.size() && time[k] < back; ++k) {
    const double m = exact.invariant(F[k] - 1.0);
    largest = std::max(largest, std::abs(m));
    error = std::max(error, std::abs(v[k] + m));
  }
  return error / largest;
}

/// The largest relative difference from c(F) of the speed with which nine levels of the front come
/// to 0.10 m; what was seen goes to a table.
double speed_error(CaseRun& run, const std::string& formulation, const SimpleWave& exact,
                   const CaseScene& scene) {
  std::vector<CaseColumn> table = {{"gradient"}, {"exact"}, {"observed"}};
  double error = 0.0;
  const double crest = value(load, crest_time);
  for (int k = 1; k <= 9; ++k) {
    const double level = 0.1 * k;
    const double sent = time_of(level);
    const double arrived = reaches(scene.samples("p3.pk1_xx"), -level * crest);
    const double H = exact.gradient_under(level * crest);
    const double seen = 0.10 / (arrived - sent);
    error = std::max(error, std::abs(seen / exact.speed(H) - 1.0));
    add_row(table, {H, exact.speed(H), seen});
  }
  run.table("speeds-" + formulation, table);
  return error;
}

/// H under the crest at the fixed end: what comes, v − m = −2m, meets v = 0, so m doubles.
double wall_gradient(const SimpleWave& exact) {
  return exact.gradient_of(2.0 * exact.invariant(exact.gradient_under(value(load, crest_time))));
}

/// The step of a run [s]: one for all of it, stable where the bar is stiffest.
double steady_step(CaseRun& run, const Settings& settings, const SimpleWave& exact) {
  const auto bar = build<1>(run.read("bar.toml", settings));
  State<1> state = state_at_rest<1>(bar);
  evaluate<1>(bar, state);
  return 0.9 * critical_step<1>(bar, state).dt * exact.speed(0.0) /
         exact.speed(wall_gradient(exact));
}

/// What the wave of the finest lattice is held to. Boundaries that are consistent leave the error
/// of the interior; others send a slightly different wave into the bar.
struct Limits {
  double field, speed, invariant;
};
Limits limits_of(const std::string& formulation) {
  if (formulation == "thesis") return {5e-3, 1e-3, 2e-3};
  if (formulation == "variational") return {1e-3, 1e-3, 2e-3};
  return {2e-4, 1e-4, 1e-4};
}

void check_large(CaseRun& run, const std::string& formulation, const SimpleWave& exact,
                 const CaseScene& scene, double stress_error) {
  const Limits limits = limits_of(formulation);
  const Checks check(run, ", " + formulation);
  const std::string source = "P(X, τ + X/c) = p(τ)";
  check(source, "relative L2 error of stress at 0.10 m", stress_error, at_most(limits.field));
  check(source, "relative L2 error of velocity at 0.10 m",
        error_against(exact.history(0.10), 1, first_reflection(exact),
                      scene.samples("p3.velocity_x")),
        at_most(limits.field));
  check("c² = (dP/dF)/ρ", "speed of nine levels to 0.10 m / c(F) − 1",
        speed_error(run, formulation, exact, scene), at_most(limits.speed));
  check("v = −∫c dF", "largest |v + m(F)| / |m| at 0.10 m", invariant_error(exact, scene),
        at_most(limits.invariant));
  const double wall = exact.stress(wall_gradient(exact));
  const bool variational = formulation == "variational";
  check("m(F) doubles", "largest pressure at the fixed end [Pa]", peak(scene.samples("p4.pk1_xx")),
        variational ? reported(-wall) : relative(-wall, 1e-3));
  // Only these forces come from an energy.
  const bool conserved = variational || formulation == "stress-point";
  check("energy", "drift of the energy balance", scene.summary.energy.drift_relative,
        conserved ? at_most(1e-4) : reported());
}

/// The wave of 10 % strain, on three lattices.
void large_wave(CaseRun& run, const SimpleWave& exact) {
  constexpr std::array spacings = {5e-4, 2.5e-4, 1.25e-4};
  const History there = exact.history(0.10);
  run.table("exact",
            {{"time", there.time}, {"stress", there.values[0]}, {"velocity", there.values[1]}});
  run.check("characteristics", "way until the wave breaks [m]", exact.breaking_distance(),
            at_least(validation_bar::length));
  std::vector<CaseColumn> table = {{"formulation"}, {"spacing"}, {"error"}};
  for (std::size_t number = 0; number < formulations.size(); ++number) {
    const std::string formulation = formulations.at(number);
    std::vector<double> errors;
    for (const double spacing : spacings) {
      const Settings bar = {"formulation=" + formulation, fmt::format("body.spacing={}", spacing)};
      const double step = steady_step(run, bar, exact);
      const CaseScene scene = run.scene(fmt::format("{}-{}", formulation, spacing), "bar.toml",
                                        with(bar, {fmt::format("time.step={}", step)}));
      errors.push_back(
          error_against(there, 0, first_reflection(exact), scene.samples("p3.pk1_xx")));
      add_row(table, {static_cast<double>(number), spacing, errors.back()});
      if (spacing == spacings.back()) check_large(run, formulation, exact, scene, errors.back());
    }
    const bool consistent = formulation == "mirror" || formulation == "stress-point";
    run.check("P(X, τ + X/c) = p(τ)", "order of convergence of the stress, " + formulation,
              pairwise_orders(spacings, errors).back(),
              consistent ? absolute(2.0, 0.05) : reported());
  }
  run.table("errors", table);
}

/// Figs 5.3 and 5.4: the pulse of 100 kPa, which bends no curve.
void small_wave(CaseRun& run) {
  const std::string pulse =
      R"(boundary[0].traction={ curve = "pulse", amplitude = -100e3, duration = 8e-6, rise = 0.5e-6 })";
  for (const std::string formulation : formulations) {
    const Settings set = {"formulation=" + formulation, pulse};
    const CaseScene nonlinear = run.scene("small-" + formulation, "bar.toml", set);
    const CaseScene linear =
        run.scene("linear-" + formulation, "bar.toml", with(set, {"material.law=linear-elastic"}));
    run.check("thesis, Fig. 5.4",
              "stress at 0.10 m less the linear one, relative L2, " + formulation,
              relative_error({linear.history.time, nonlinear.probe("p3.pk1_xx")},
                             linear.probe("p3.pk1_xx")),
              at_most(1e-5));
  }
}

}  // namespace

void neo_hookean_wave(CaseRun& run) {
  large_wave(run, exact_wave());
  small_wave(run);
}

}  // namespace tlsph

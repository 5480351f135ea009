// Below, at and above the largest stable step: the step the program computes, how a run grows
// beyond it, how the thesis's rule h/c compares, and what grows at any step.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "list.hpp"
#include "samples.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/stepping/stepper.hpp"
#include "validation_bar.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

using Spectrum = std::vector<std::complex<double>>;

const double speed = validation_bar::speed;
const double transit = validation_bar::length / speed;
constexpr double history = 44e-6;  // of the figure [s]

Settings with_step(const Settings& set, double dt, double end) {
  return with(set, {fmt::format("time.step={}", dt), fmt::format("time.end={}", end),
                    "time.allow_unstable=true"});
}

Spectrum spectrum_of(CaseRun& run, const Settings& set) {
  return eigenvalues(dynamical_matrix<1>(build<1>(run.read("bar.toml", set))));
}

double computed_limit(CaseRun& run, const Settings& set) {
  return run.scene("limit", "bar.toml", with(set, {"time.end=1e-7"})).summary.dt_critical;
}

double largest_stress(const CaseScene& wave) {
  return peak(wave.samples("p2.pk1_xx")) / validation_bar::pressure;
}

/// The growth per step [1] of the largest displacement between 1e20 and 1e100 m, of the scene's own
/// operators and loads: a run of the program ends where growth starts.
double observed_growth(CaseRun& run, const Settings& set, double dt) {
  constexpr double from = 1e20;
  constexpr double to = 1e100;
  constexpr long most_steps = 2'000'000;
  const auto body = build<1>(run.read("bar.toml", set));
  const VectorField<1> rest = VectorField<1>::Zero(body.nodes(), 1);
  Stepper<1> stepper(body, rest, rest,
                     {.step = dt, .balance_every = 0, .evaluate = evaluate_unchecked<1>});
  const State<1>& state = stepper.state();
  long first = 0;
  long last = 0;
  double bottom = 0.0;
  double top = 0.0;
  while (top < to && state.step < most_steps) {
    stepper.step();
    const double now = state.u.cwiseAbs().maxCoeff();
    if (now <= top) continue;
    top = now;
    last = state.step;
    if (top > from) continue;
    bottom = top;
    first = last;
  }
  return std::log(top / bottom) / static_cast<double>(last - first);
}

/// Histories for the figure at half the limit, at the limit, and above it.
void draw_around(CaseRun& run, const std::string& name, const Settings& set, double limit) {
  for (const auto& [words, share] : {std::pair{"below", 0.5}, {"at", 0.999}, {"above", 1.02}})
    (void)run.scene(fmt::format("{}-{}", name, words), "bar.toml",
                    with_step(set, share * limit, history));
}

/// Figs 4.10 to 4.12 with operators that do not grow by themselves.
void around_the_limit(CaseRun& run) {
  for (const std::string formulation : {"mirror", "stress-point", "variational"}) {
    const Settings set = {"formulation=" + formulation};
    const Spectrum spectrum = spectrum_of(run, set);
    const double limit = 2.0 / std::sqrt(spectrum.front().real());
    const double computed = computed_limit(run, set);
    const double per_spacing = speed / 5e-4;
    const Checks check(run, ", " + formulation);
    check("spectrum of the operators", "computed limit c_p Δt/Δ", computed * per_spacing,
          relative(limit * per_spacing, 2e-3));
    const CaseScene below = run.scene(formulation + "-long-below", "bar.toml",
                                      with_step(set, 0.99 * computed, 100.0 * transit));
    check("thesis, Fig. 4.10", "largest stress / 100 kPa in 100 transits at 0.99 of the limit",
          largest_stress(below), at_most(2.0));
    const double dt = 1.02 * computed;
    check("thesis, Fig. 4.12", "growth a step at 1.02 of the limit", observed_growth(run, set, dt),
          relative(growth_per_step(spectrum, dt), 1e-2));
    const CaseScene above =
        run.scene(formulation + "-long-above", "bar.toml", with_step(set, dt, 100.0 * transit));
    check("books of the run", "end of a run at 1.02 of the limit, in transits",
          above.failed_at.value_or(INFINITY) / transit, at_most(10.0));
    draw_around(run, formulation, set, computed);
  }
}

/// At its limit, one spacing a step, the error of the step cancels that of the stress-point
/// operators: a square pulse stays square.
void ripples_at_the_limit(CaseRun& run) {
  const std::string square =
      R"(boundary[0].traction={ curve = "table", time = [0, 8e-6, 8.001e-6], value = [1, 1, 0], amplitude = -100e3 })";
  for (const double share : {0.5, 1.0}) {
    const double dt = share * 5e-4 / speed;
    const CaseScene wave = run.scene(
        fmt::format("square-{}", share), "bar.toml",
        with_step({"formulation=stress-point", square}, dt, std::round(history / dt) * dt));
    run.check(
        "thesis, Fig. 4.11",
        fmt::format("largest stress of a square pulse / 100 kPa, c Δt = {} Δ, stress-point", share),
        largest_stress(wave), share == 1.0 ? relative(1.0, 1e-6) : reported(1.0));
  }
}

/// The thesis's bar of 1000 spacings with a support of 5.5, boundaries as printed, at its step.
void rule_of_the_thesis(CaseRun& run) {
  constexpr double spacing = 1.5e-4;
  const double bar_speed = std::sqrt(validation_bar::young / validation_bar::density);
  const double rule = 5.5 * spacing / bar_speed;
  const Settings coarse = {"formulation=thesis", "boundary_treatment=as-printed",
                           "kernel.support=5.5"};
  const Settings fine = with(coarse, {fmt::format("body.spacing={}", spacing)});
  const double nanoseconds = 1e9;
  run.check("thesis, (4.47)", "h/c_b, 1000 spacings, support 5.5 [ns]", rule * nanoseconds,
            reported(165.0));
  const Spectrum spectrum = spectrum_of(run, coarse);
  // The limit is in proportion to the spacing.
  const double limit = spacing / 5e-4 * 2.0 / std::sqrt(std::abs(spectrum.front()));
  const double computed = computed_limit(run, fine);
  run.check("spectrum of the operators", "limit, 1D strain, support 5.5, thesis as printed [ns]",
            computed * nanoseconds, relative(limit * nanoseconds, 2e-3));
  run.check("thesis, (4.47)", "growth a step at h/c_b, 1D strain, thesis as printed",
            observed_growth(run, fine, rule),
            relative(growth_per_step(spectrum, rule * 5e-4 / spacing), 1e-2));
  const Settings stress = with(fine, {"material.assumption=stress"});
  run.check("thesis, Algorithm 4.1", "limit with E in place of λ + 2μ, support 5.5 [ns]",
            computed_limit(run, stress) * nanoseconds, reported());
  const CaseScene bar =
      run.scene("thesis-rule-stress", "bar.toml", with_step(stress, rule, history));
  run.check("thesis, Algorithm 4.1", "largest stress / 100 kPa at h/c_b with E, thesis as printed",
            largest_stress(bar), at_most(2.0));
  draw_around(run, "thesis", fine, computed);
}

/// What grows at any step, as the operators are not adjoint.
void growth_of_the_operators(CaseRun& run) {
  const double per_spacing = 5e-4 / speed;
  std::vector<CaseColumn> table = {{"closure"}, {"growth"}, {"frequency"}};
  for (const double support : {2.5, 3.5, 5.5}) {
    int number = 0;
    for (const std::string closure : {"consistent", "as-printed", "eta", "mirror"}) {
      const bool thesis = closure != "mirror";
      Settings set = {thesis ? "formulation=thesis" : "formulation=mirror",
                      fmt::format("kernel.support={}", support)};
      if (thesis) set.push_back("boundary_treatment=" + closure);
      const Spectrum spectrum = spectrum_of(run, set);
      const double growth = growth_rate(spectrum) * per_spacing;
      const std::string of =
          fmt::format(", {}{}, support {}", thesis ? "thesis " : "", closure, support);
      run.check(thesis ? "thesis, (2.46)" : "spectrum of the operators",
                "growth at any step [c/Δ]" + of, growth, thesis ? reported() : at_most(1e-6));
      if (support == 5.5)
        for (const std::complex<double>& square : spectrum) {
          const std::complex<double> s = std::sqrt(-square) * per_spacing;
          add_row(table, {static_cast<double>(number), s.real(), std::abs(s.imag())});
        }
      ++number;
      if (closure != "consistent" || support != 5.5) continue;
      const double dt = 0.9 * computed_limit(run, set);
      (void)run.scene("thesis-long-consistent", "bar.toml", with_step(set, dt, 100.0 * transit));
      run.check("spectrum of the operators", "growth a step at 0.9 of the limit" + of,
                observed_growth(run, set, dt), relative(growth_per_step(spectrum, dt), 1e-2));
    }
  }
  run.table("spectrum", table);
}

}  // namespace

void step_limit(CaseRun& run) {
  around_the_limit(run);
  ripples_at_the_limit(run);
  rule_of_the_thesis(run);
  growth_of_the_operators(run);
}

}  // namespace tlsph

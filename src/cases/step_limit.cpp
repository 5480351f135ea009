// Below, at and above the largest stable step: the step the program computes, how a run grows
// beyond it, how the thesis's rule h/c compares, and what grows at any step.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "bar_wave_run.hpp"
#include "list.hpp"
#include "signals.hpp"
#include "tlsph/analysis/motion_growth.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/stepping/stepper.hpp"
#include "validation_bar.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

using Settings = std::vector<std::string>;
using Spectrum = std::vector<std::complex<double>>;

const double speed = validation_bar::speed;
const double transit = validation_bar::length / speed;
constexpr double history = 44e-6;  // of the figure [s]

Settings with(Settings set, const Settings& more) {
  set.insert(set.end(), more.begin(), more.end());
  return set;
}

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

double largest_stress(const BarWaveRun& wave) {
  return peak(wave.time(), wave.stress("p2"), 0.0, wave.time().back()) / validation_bar::pressure;
}

/// The growth per step [1] of the largest displacement between 1e20 and 1e100 m, of the scene's own
/// operators and loads: a run of the program ends where growth starts.
double observed_growth(CaseRun& run, const Settings& set, double dt) {
  constexpr double from = 1e20;
  constexpr double to = 1e100;
  constexpr long most_steps = 2'000'000;
  const auto disc = build<1>(run.read("bar.toml", set));
  const VectorField<1> rest = VectorField<1>::Zero(disc.nodes(), 1);
  Stepper<1> stepper(disc, rest, rest,
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
    const std::string of = ", " + formulation;
    run.relative("spectrum of the operators", "computed limit c_p Δt/Δ" + of, limit * per_spacing,
                 computed * per_spacing, 2e-3);
    const BarWaveRun below(run, formulation + "-long-below", "bar.toml",
                           with_step(set, 0.99 * computed, 100.0 * transit));
    run.at_most("thesis, Fig. 4.10",
                "largest stress / 100 kPa in 100 transits at 0.99 of the limit" + of, 2.0,
                largest_stress(below));
    const double dt = 1.02 * computed;
    run.relative("thesis, Fig. 4.12", "growth a step at 1.02 of the limit" + of,
                 growth_per_step(spectrum, dt), observed_growth(run, set, dt), 1e-2);
    const CaseScene above =
        run.scene(formulation + "-long-above", "bar.toml", with_step(set, dt, 100.0 * transit));
    run.at_most("books of the run", "end of a run at 1.02 of the limit, in transits" + of, 10.0,
                above.failed_at.value_or(INFINITY) / transit);
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
    const BarWaveRun wave(
        run, fmt::format("square-{}", share), "bar.toml",
        with_step({"formulation=stress-point", square}, dt, std::round(history / dt) * dt));
    const std::string words =
        fmt::format("largest stress of a square pulse / 100 kPa, c Δt = {} Δ, stress-point", share);
    if (share == 1.0)
      run.relative("thesis, Fig. 4.11", words, 1.0, largest_stress(wave), 1e-6);
    else
      run.report("thesis, Fig. 4.11", words, largest_stress(wave), 1.0);
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
  run.report("thesis, (4.47)", "h/c_b, 1000 spacings, support 5.5 [ns]", rule * nanoseconds, 165.0);
  const Spectrum spectrum = spectrum_of(run, coarse);
  // The limit is in proportion to the spacing.
  const double limit = spacing / 5e-4 * 2.0 / std::sqrt(std::abs(spectrum.front()));
  const double computed = computed_limit(run, fine);
  run.relative("spectrum of the operators", "limit, 1D strain, support 5.5, thesis as printed [ns]",
               limit * nanoseconds, computed * nanoseconds, 2e-3);
  run.relative("thesis, (4.47)", "growth a step at h/c_b, 1D strain, thesis as printed",
               growth_per_step(spectrum, rule * 5e-4 / spacing), observed_growth(run, fine, rule),
               1e-2);
  const Settings stress = with(fine, {"material.assumption=stress"});
  run.report("thesis, Algorithm 4.1", "limit with E in place of λ + 2μ, support 5.5 [ns]",
             computed_limit(run, stress) * nanoseconds);
  const BarWaveRun bar(run, "thesis-rule-stress", "bar.toml", with_step(stress, rule, history));
  run.at_most("thesis, Algorithm 4.1",
              "largest stress / 100 kPa at h/c_b with E, thesis as printed", 2.0,
              largest_stress(bar));
  draw_around(run, "thesis", fine, computed);
}

/// What grows at any step, as the operators are not adjoint.
void growth_of_the_operators(CaseRun& run) {
  const double per_spacing = 5e-4 / speed;
  std::vector<std::vector<double>> table(3);
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
      if (thesis)
        run.report("thesis, (2.46)", "growth at any step [c/Δ]" + of, growth);
      else
        run.at_most("spectrum of the operators", "growth at any step [c/Δ]" + of, 1e-6, growth);
      if (support == 5.5)
        for (const std::complex<double>& square : spectrum) {
          const std::complex<double> s = std::sqrt(-square) * per_spacing;
          table[0].push_back(number);
          table[1].push_back(s.real());
          table[2].push_back(std::abs(s.imag()));
        }
      ++number;
      if (closure != "consistent" || support != 5.5) continue;
      const double dt = 0.9 * computed_limit(run, set);
      (void)run.scene("thesis-long-consistent", "bar.toml", with_step(set, dt, 100.0 * transit));
      run.relative("spectrum of the operators", "growth a step at 0.9 of the limit" + of,
                   growth_per_step(spectrum, dt), observed_growth(run, set, dt), 1e-2);
    }
  }
  run.table("spectrum", {"closure", "growth", "frequency"}, table);
}

}  // namespace

void step_limit(CaseRun& run) {
  around_the_limit(run);
  ripples_at_the_limit(run);
  rule_of_the_thesis(run);
  growth_of_the_operators(run);
}

}  // namespace tlsph

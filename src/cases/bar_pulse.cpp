// The validation bar of the thesis: three smoothings of one pulse, four formulations, three
// supports, held against d'Alembert's solution.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "list.hpp"
#include "samples.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/model/builder.hpp"
#include "validation_bar.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

constexpr double amplitude = validation_bar::pressure;
constexpr double duration = validation_bar::duration;
const double speed = validation_bar::speed;
constexpr PulseCurve intermediate{-amplitude, duration, 0.5e-6};  // the smoothing of most runs
using validation_bar::formulations;

/// Where the front of a stress step stands: with the dispersion of a lattice a step arrives as ∫Ai,
/// whose value at the place of the exact front is 1/3, and whose largest, at the first zero of Ai,
/// is 1.2743…, at any resolution.
constexpr double front_level = 1.0 / 3.0;
constexpr double front_overshoot = 1.274352;

const std::string load = "boundary[0].traction";

/// The thesis's own boundaries cost it accuracy everywhere.
double within(const std::string& formulation, double tolerance, double of_thesis) {
  return formulation == "thesis" ? of_thesis : tolerance;
}

/// The largest difference of the stress at the loaded particle from the load, over its amplitude.
double traction_error(const CaseScene& wave) {
  return largest_difference(wave.probe("p1.pk1_xx"), wave.exact_samples("p1.pk1_xx").values) /
         amplitude;
}

/// The mean over the middle of a pulse that has come a way of `x` metres.
double plateau(const Samples& stress, double rise, double x) {
  const double middle = 3.0 * rise + duration / 2.0 + x / speed;
  return mean(stress, middle - 2e-6, middle + 2e-6);
}

/// Figs 4.7, 4.8 and 4.13: smooth pulses enter the bar, double at its fixed end and come back.
void smooth_pulses(CaseRun& run) {
  for (const auto& [smoothing, figure, rise] :
       {std::tuple{"large", "thesis, Fig. 4.7", 2e-6},
        std::tuple{"intermediate", "thesis, Fig. 4.8", intermediate.rise}})
    for (const std::string formulation : formulations) {
      const CaseScene wave =
          run.scene(fmt::format("{}-{}", smoothing, formulation), "bar.toml",
                    {"formulation=" + formulation, fmt::format("{}.rise={}", load, rise)});
      const Checks check(run, fmt::format(", {} smoothing, {}", smoothing, formulation));
      const bool exact_edge = formulation == "thesis" || formulation == "mirror";
      check(figure, "stress at point 1 less the load, / 100 kPa", traction_error(wave),
            exact_edge ? at_most(1e-9) : reported());
      for (const auto& [probe, x] : {std::pair{"p2.pk1_xx", 0.05}, std::pair{"p3.pk1_xx", 0.10}})
        check(figure, fmt::format("half of the pressure at {} m [s]", x),
              reaches(wave.samples(probe), 0.5 * amplitude),
              relative(3.0 * rise + x / speed, within(formulation, 2e-3, 5e-3)));
      const double doubled = plateau(wave.exact_samples("p4.pk1_xx"), rise, 0.15);
      check("thesis, Fig. 4.13", "stress at the fixed end, mean over the pulse [Pa]",
            plateau(wave.samples("p4.pk1_xx"), rise, 0.15),
            formulation == "variational" ? reported(doubled)
                                         : relative(doubled, within(formulation, 1e-3, 5e-3)));
      check("thesis, (4.43)", "tension at 0.05 m, back from the loaded end [Pa]",
            plateau(wave.samples("p2.pk1_xx"), rise, 0.35),
            relative(plateau(wave.exact_samples("p2.pk1_xx"), rise, 0.35),
                     within(formulation, 2e-3, 1e-2)));
      check("thesis, Fig. 4.13", "displacement of the fixed end [m]",
            peak(wave.samples("p4.displacement_x")), at_most(0.0));
      check("d'Alembert", "relative L2 error of stress at 0.05 m",
            relative_error(wave, "p2.pk1_xx"), reported());
    }
}

/// Fig. 4.9: the square pulse. Dispersion makes ripples of every jump; where its front is and how
/// high they are at most does not depend on the operator.
void square_pulses(CaseRun& run) {
  const std::string square = fmt::format(
      "{}={{ curve = \"table\", time = [0, {}, {}], value = [1, 1, 0], amplitude = {} }}", load,
      duration, 1.0001 * duration, -amplitude);
  for (const std::string formulation : formulations) {
    // Small steps, or their errors cancel those of the operators in part.
    const CaseScene wave = run.scene("none-" + formulation, "bar.toml",
                                     {"formulation=" + formulation, square, "time.safety=0.3"});
    const Checks check(run, ", no smoothing, " + formulation);
    const double arrived = 0.10 / speed;
    check("dispersion of the lattice", "a third of the pressure at 0.10 m [s]",
          reaches(wave.samples("p3.pk1_xx"), front_level * amplitude),
          relative(arrived, within(formulation, 3e-4, 2e-3)));
    check("thesis, Fig. 4.9; Airy", "largest stress at 0.10 m [Pa]",
          peak(wave.samples("p3.pk1_xx"), arrived + duration),
          relative(front_overshoot * amplitude, within(formulation, 1e-2, 2e-2)));
  }
}

/// The other closures of the thesis, and a free end in place of the fixed one.
void other_ends(CaseRun& run) {
  for (const std::string treatment : {"as-printed", "eta"}) {
    const CaseScene wave = run.scene("intermediate-" + treatment, "bar.toml",
                                     {"formulation=thesis", "boundary_treatment=" + treatment});
    const Checks check(run, ", intermediate smoothing, thesis " + treatment);
    check("thesis, (2.47)", "stress at point 1 less the load, / 100 kPa", traction_error(wave),
          at_most(1e-9));
    check("d'Alembert", "relative L2 error of stress at 0.05 m", relative_error(wave, "p2.pk1_xx"),
          reported());
  }
  const std::string left_only = fmt::format(
      R"(boundary=[{{ where = "left", traction = {{ curve = "pulse", amplitude = {}, duration = {}, rise = {} }} }}])",
      -amplitude, duration, intermediate.rise);
  for (const std::string formulation : formulations) {
    const CaseScene wave = run.scene("free-" + formulation, "bar.toml",
                                     {"formulation=" + formulation, left_only, "time.end=50e-6"});
    const Checks check(run, ", free right end, " + formulation);
    check("thesis, (4.43)", "tension at 0.10 m [Pa]",
          plateau(wave.samples("p3.pk1_xx"), intermediate.rise, 0.20),
          relative(plateau(wave.exact_samples("p3.pk1_xx"), intermediate.rise, 0.20),
                   within(formulation, 2e-3, 1e-2)));
    check("thesis, sec. 4.6.3.4", "stress at the right end [Pa]", peak(wave.samples("p4.pk1_xx")),
          formulation == "thesis" || formulation == "mirror" ? at_most(0.0) : reported(0.0));
  }
}

/// The a of ω = c k (1 − a (kΔ)² + O((kΔ)⁴)), a free wave of wave number k in the middle of a
/// uniform, linear elastic bar of particles, operators and time step `dt` together: the run's own
/// force on u = cos(kX) gives ω² of the operators, the central difference adds −(c dt/Δ)²/24.
/// Positive: short waves are late.
double long_wave_lag(const Discretisation<1>& bar, double dt) {
  // Small enough for the leading term, large enough for its digits.
  const double theta = 0.02;
  const double k = theta / bar.spacing;
  const double omega = std::sqrt(squared_frequency(bar, bar.nodes() / 2, k));
  const double courant = bar.wave_speed() * dt / bar.spacing;
  return (1.0 - omega / (bar.wave_speed() * k)) / (theta * theta) - courant * courant / 24.0;
}

/// Relative L2 error in time that the dispersion a leaves in the stress at 0.10 m, which the pulse
/// passes after ways of x = 0.10 and 0.20 m: a Δ² x ‖p'''‖/‖p‖/c³, for the erf pulse p of rise r
/// and duration T ≫ r.
double dispersion_error(double a, double spacing) {
  const double way = std::sqrt((0.10 * 0.10 + 0.20 * 0.20) / 2.0);
  const double sigma = speed * intermediate.rise;
  const double length = speed * duration;
  // Both flanks are erf(s)/2 with s = x/σ; ∫ (4s² − 2)² e^{−2s²} ds = 3 √(π/2).
  const double third =
      2.0 * 3.0 * std::sqrt(std::numbers::pi / 2.0) / (std::numbers::pi * std::pow(sigma, 5));
  const double norm = length - sigma * std::sqrt(2.0 / std::numbers::pi);
  return std::abs(a) * spacing * spacing * way * std::sqrt(third / norm);
}

/// Accuracy and cost of one kernel, on three lattices; a support of zero: the nodes of a cell.
void accuracy(CaseRun& run, const std::string& formulation, double support,
              std::vector<CaseColumn>& table) {
  const bool thesis = formulation == "thesis";
  const bool cell = support == 0.0;
  const Checks check(run, ", " + formulation + (cell ? "" : fmt::format(", support {}", support)));
  const auto number = std::ranges::find(formulations, formulation) - formulations.begin();
  const std::array spacings = {5e-4, 2.5e-4, 1.25e-4};
  std::vector<double> errors;
  for (const double spacing : spacings) {
    const Settings set = {"formulation=" + formulation, "time.end=50e-6",
                          fmt::format("body.spacing={}", spacing),
                          cell ? "output.frames=0" : fmt::format("kernel.support={}", support)};
    const CaseScene wave =
        run.scene(fmt::format("{}-{}-{}", formulation, support, spacing), "bar.toml", set);
    if (wave.failed_at) {
      if (spacing == spacings.back())
        check("books of the run", "time when growth ends the run, 1200 cells [s]", *wave.failed_at,
              reported());
      continue;
    }
    const Summary& summary = wave.summary;
    errors.push_back(relative_error(wave, "p3.pk1_xx"));
    add_row(table, {static_cast<double>(number), support, spacing, errors.back(),
                    static_cast<double>(summary.nonzeros) * static_cast<double>(summary.steps)});
    if (spacing != spacings.back()) continue;
    const double lag = long_wave_lag(build<1>(run.read("bar.toml", set)), summary.dt);
    const double predicted = dispersion_error(lag, spacing);
    check("dispersion of the lattice", "relative L2 error of stress at 0.10 m, 1200 cells",
          errors.back(), thesis ? reported(predicted) : relative(predicted, 5e-2));
    check("thesis, (4.47)", "critical step c_p Δt/Δ", summary.dt_critical_scaled,
          cell ? reported() : reported(support));
  }
  if (errors.size() < spacings.size()) return;
  check("d'Alembert", "order of convergence of that error",
        pairwise_orders(spacings, errors).back(), thesis ? reported() : absolute(2.0, 0.1));
}

void supports(CaseRun& run) {
  std::vector<CaseColumn> table = {
      {"formulation"}, {"support"}, {"spacing"}, {"error"}, {"products"}};
  for (const std::string formulation : {"thesis", "mirror"})
    for (const double support : {2.5, 3.5, 5.5}) accuracy(run, formulation, support, table);
  accuracy(run, "stress-point", 0.0, table);
  accuracy(run, "variational", 2.5, table);
  run.table("supports", table);
}

}  // namespace

void bar_pulse(CaseRun& run) {
  smooth_pulses(run);
  square_pulses(run);
  other_ends(run);
  supports(run);
}

}  // namespace tlsph

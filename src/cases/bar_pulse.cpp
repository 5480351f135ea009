// The validation bar of the thesis: three smoothings of one pulse, four formulations, three
// supports, held against d'Alembert's solution.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "bar_wave_run.hpp"
#include "list.hpp"
#include "long_waves.hpp"
#include "signals.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/model/builder.hpp"
#include "validation_bar.hpp"

namespace tlsph {
namespace {

constexpr double amplitude = validation_bar::pressure;
constexpr double duration = validation_bar::duration;
const double speed = validation_bar::speed;
constexpr PulseCurve intermediate{-amplitude, duration, 0.5e-6};  // the smoothing of most runs
const std::array<std::string, 4> formulations = {"thesis", "mirror", "stress-point", "variational"};

const std::string load = "boundary[0].traction";

/// The thesis's own boundaries cost it accuracy everywhere.
double within(const std::string& formulation, double tolerance, double of_thesis) {
  return formulation == "thesis" ? of_thesis : tolerance;
}

/// The largest difference of the stress at the loaded particle from the load, over its amplitude.
double traction_error(const BarWaveRun& wave) {
  return largest_difference(wave.stress("p1"), wave.exact_stress("p1")) / amplitude;
}

/// Means of computed and exact stress over the middle of a pulse that has come a way of `x` metres.
struct Plateau {
  double observed, exact;
};
Plateau plateau(const BarWaveRun& wave, const std::string& probe, double rise, double x) {
  const double middle = 3.0 * rise + duration / 2.0 + x / speed;
  const auto over = [&](std::span<const double> values) {
    return mean(wave.time(), values, middle - 2e-6, middle + 2e-6);
  };
  return {over(wave.stress(probe)), over(wave.exact_stress(probe))};
}

/// Figs 4.7, 4.8 and 4.13: smooth pulses enter the bar, double at its fixed end and come back.
void smooth_pulses(CaseRun& run) {
  for (const auto& [smoothing, figure, rise] :
       {std::tuple{"large", "thesis, Fig. 4.7", 2e-6},
        std::tuple{"intermediate", "thesis, Fig. 4.8", intermediate.rise}})
    for (const std::string& formulation : formulations) {
      const BarWaveRun wave(run, fmt::format("{}-{}", smoothing, formulation), "bar.toml",
                            {"formulation=" + formulation, fmt::format("{}.rise={}", load, rise)});
      const std::string of = fmt::format(", {} smoothing, {}", smoothing, formulation);
      const bool exact_edge = formulation == "thesis" || formulation == "mirror";
      if (exact_edge)
        run.at_most(figure, "stress at point 1 less the load, / 100 kPa" + of, 1e-9,
                    traction_error(wave));
      else
        run.report(figure, "stress at point 1 less the load, / 100 kPa" + of, traction_error(wave));
      for (const auto& [probe, x] : {std::pair{"p2", 0.05}, std::pair{"p3", 0.10}})
        run.relative(figure, fmt::format("half of the pressure at {} m{} [s]", x, of),
                     3.0 * rise + x / speed,
                     reaches(wave.time(), wave.stress(probe), 0.5 * amplitude),
                     within(formulation, 2e-3, 5e-3));
      const Plateau doubled = plateau(wave, "p4", rise, 0.15);
      const std::string wall = "stress at the fixed end, mean over the pulse" + of + " [Pa]";
      if (formulation != "variational")
        run.relative("thesis, Fig. 4.13", wall, doubled.exact, doubled.observed,
                     within(formulation, 1e-3, 5e-3));
      else
        run.report("thesis, Fig. 4.13", wall, doubled.observed, doubled.exact);
      const Plateau back = plateau(wave, "p2", rise, 0.35);
      run.relative("thesis, (4.43)", "tension at 0.05 m, back from the loaded end" + of + " [Pa]",
                   back.exact, back.observed, within(formulation, 2e-3, 1e-2));
      run.at_most("thesis, Fig. 4.13", "displacement of the fixed end" + of + " [m]", 0.0,
                  peak(wave.time(), wave.scene.probe("p4.displacement_x"), 0.0, 1.0));
      run.report("d'Alembert", "relative L2 error of stress at 0.05 m" + of, wave.error("p2"));
    }
}

/// Fig. 4.9: the square pulse. Dispersion makes ripples of every jump; where its front is and how
/// high they are at most does not depend on the operator.
void square_pulses(CaseRun& run) {
  const std::string square = fmt::format(
      "{}={{ curve = \"table\", time = [0, {}, {}], value = [1, 1, 0], amplitude = {} }}", load,
      duration, 1.0001 * duration, -amplitude);
  for (const std::string& formulation : formulations) {
    // Small steps, or their errors cancel those of the operators in part.
    const BarWaveRun wave(run, "none-" + formulation, "bar.toml",
                          {"formulation=" + formulation, square, "time.safety=0.3"});
    const std::string of = ", no smoothing, " + formulation;
    const double arrived = 0.10 / speed;
    run.relative("dispersion of the lattice", "a third of the pressure at 0.10 m" + of + " [s]",
                 arrived, reaches(wave.time(), wave.stress("p3"), front_level * amplitude),
                 within(formulation, 3e-4, 2e-3));
    run.relative("thesis, Fig. 4.9; Airy", "largest stress at 0.10 m" + of + " [Pa]",
                 front_overshoot * amplitude,
                 peak(wave.time(), wave.stress("p3"), 0.0, arrived + duration),
                 within(formulation, 1e-2, 2e-2));
  }
}

/// The other closures of the thesis, and a free end in place of the fixed one.
void other_ends(CaseRun& run) {
  for (const std::string treatment : {"as-printed", "eta"}) {
    const BarWaveRun wave(run, "intermediate-" + treatment, "bar.toml",
                          {"formulation=thesis", "boundary_treatment=" + treatment});
    const std::string of = ", intermediate smoothing, thesis " + treatment;
    run.at_most("thesis, (2.47)", "stress at point 1 less the load, / 100 kPa" + of, 1e-9,
                traction_error(wave));
    run.report("d'Alembert", "relative L2 error of stress at 0.05 m" + of, wave.error("p2"));
  }
  const std::string left_only = fmt::format(
      R"(boundary=[{{ where = "left", traction = {{ curve = "pulse", amplitude = {}, duration = {}, rise = {} }} }}])",
      -amplitude, duration, intermediate.rise);
  for (const std::string& formulation : formulations) {
    const BarWaveRun wave(run, "free-" + formulation, "bar.toml",
                          {"formulation=" + formulation, left_only, "time.end=50e-6"});
    const std::string of = ", free right end, " + formulation + " [Pa]";
    const Plateau back = plateau(wave, "p3", intermediate.rise, 0.20);
    run.relative("thesis, (4.43)", "tension at 0.10 m" + of, back.exact, back.observed,
                 within(formulation, 2e-3, 1e-2));
    const double end = peak(wave.time(), wave.stress("p4"), 0.0, 1.0);
    if (formulation == "thesis" || formulation == "mirror")
      run.at_most("thesis, sec. 4.6.3.4", "stress at the right end" + of, 0.0, end);
    else
      run.report("thesis, sec. 4.6.3.4", "stress at the right end" + of, end, 0.0);
  }
}

/// The relative L2 error of the stress at 0.10 m, which the pulse passes after ways of 0.10 and
/// 0.20 m, on a lattice of so many spacings; `predicted` from the dispersion of the lattice.
struct SupportRun {
  double observed, predicted, scaled_step, products;
  std::optional<double> lost;  ///< when growth ended the run [s]
};
SupportRun run_support(CaseRun& run, const std::string& formulation, double support,
                       double spacing) {
  const std::vector<std::string> set = {
      "formulation=" + formulation, "time.end=50e-6", fmt::format("body.spacing={}", spacing),
      support > 0.0 ? fmt::format("kernel.support={}", support) : "output.frames=0"};
  const BarWaveRun wave(run, fmt::format("{}-{}-{}", formulation, support, spacing), "bar.toml",
                        set);
  const Summary& summary = wave.scene.summary;
  const double way = std::sqrt((0.10 * 0.10 + 0.20 * 0.20) / 2.0);
  const double a = long_wave_lag(build<1>(run.read("bar.toml", set)), summary.dt);
  return {wave.error("p3"), pulse_dispersion_error(a, spacing, way, intermediate, speed),
          summary.dt_critical_scaled,
          static_cast<double>(summary.nonzeros) * static_cast<double>(summary.steps),
          wave.scene.failed_at};
}

/// Accuracy and cost of wide kernels, on three lattices.
void supports(CaseRun& run) {
  const std::array spacings = {5e-4, 2.5e-4, 1.25e-4};
  std::vector<std::vector<double>> table(5);
  for (const auto& [formulation, support] : {std::pair<std::size_t, double>{0, 2.5},
                                             {0, 3.5},
                                             {0, 5.5},
                                             {1, 2.5},
                                             {1, 3.5},
                                             {1, 5.5},
                                             {2, 0.0},
                                             {3, 2.5}}) {
    const std::string& name = formulations[formulation];
    const std::string of =
        ", " + name + (support > 0.0 ? fmt::format(", support {}", support) : "");
    std::vector<double> errors;
    bool lost = false;
    for (const double spacing : spacings) {
      const SupportRun now = run_support(run, name, support, spacing);
      errors.push_back(now.observed);
      const std::array row = {static_cast<double>(formulation), support, spacing, now.observed,
                              now.products};
      for (std::size_t c = 0; c < row.size() && !now.lost; ++c) table[c].push_back(row[c]);
      lost = lost || now.lost;
      if (spacing != spacings.back()) continue;
      if (now.lost) {
        run.report("books of the run", "time when growth ends the run, 1200 cells" + of + " [s]",
                   *now.lost);
        continue;
      }
      const std::string words = "relative L2 error of stress at 0.10 m, 1200 cells" + of;
      if (name == "thesis")
        run.report("dispersion of the lattice", words, now.observed, now.predicted);
      else
        run.relative("dispersion of the lattice", words, now.predicted, now.observed, 5e-2);
      run.report("thesis, (4.47)", "critical step c_p Δt/Δ" + of, now.scaled_step,
                 support > 0.0 ? std::optional(support) : std::nullopt);
    }
    if (lost) continue;
    const double order = pairwise_orders(spacings, errors).back();
    const std::string words = "order of convergence of that error" + of;
    if (name == "thesis")
      run.report("d'Alembert", words, order);
    else
      run.absolute("d'Alembert", words, 2.0, order, 0.1);
  }
  run.table("supports", {"formulation", "support", "spacing", "error", "products"}, table);
}

}  // namespace

void bar_pulse(CaseRun& run) {
  smooth_pulses(run);
  square_pulses(run);
  other_ends(run);
  supports(run);
}

}  // namespace tlsph

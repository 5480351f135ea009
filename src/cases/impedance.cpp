// A density change at midspan: what of a pulse comes back from it, what goes on.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <tuple>

#include "list.hpp"
#include "signals.hpp"
#include "two_part_bar.hpp"
#include "validation_bar.hpp"

namespace tlsph {
namespace {

constexpr PulseCurve pulse{-validation_bar::pressure, 5e-6, 0.6e-6};
constexpr double interface = 0.5 * validation_bar::length;
constexpr double place_a = 0.0375;  // of the probes [m]
constexpr double place_b = 0.1125;
constexpr double place_wall = 0.074;        // close to the interface, in the material that is there
constexpr double flank = 2.4 * pulse.rise;  // (1 − erf)/2 is 3e-4 after it
const std::array<std::string, 4> formulations = {"thesis", "mirror", "stress-point", "variational"};

TwoPartBar bar_of(double density_ratio, bool fixed_end) {
  const double speed = validation_bar::speed;
  return {interface,
          validation_bar::length,
          speed,
          speed / std::sqrt(density_ratio),
          std::sqrt(density_ratio),
          fixed_end,
          pulse};
}

/// Of the coefficients: what stress points resolve five times better than wide kernels.
double within(const std::string& formulation) {
  return formulation == "stress-point" ? 2e-3 : 1e-2;
}

/// A run and the exact stress at the three probes.
struct Wave {
  CaseScene scene;
  TwoPartBar bar;
  std::vector<std::vector<double>> exact;

  [[nodiscard]] std::span<const double> time() const { return scene.probes.computed.time; }
  /// The mean stress over the load's, while the plateau of a ray passes that set out at `start`
  /// and is alone for `alone` seconds.
  [[nodiscard]] double share(const std::string& probe, double start, double alone) const {
    const double front = 3.0 * pulse.rise + start;
    return mean(time(), scene.probe(probe + ".pk1_xx"), front + flank,
                front + std::min(pulse.duration, alone) - flank) /
           pulse.amplitude;
  }
  [[nodiscard]] double error(const std::string& probe, std::size_t number) const {
    return relative_error(time(), scene.probe(probe + ".pk1_xx"), exact[number]);
  }
};

Wave run_wave(CaseRun& run, const std::string& label, const std::vector<std::string>& set,
              const TwoPartBar& bar) {
  Wave wave{run.scene(label, "bar.toml", set), bar, {}};
  const auto& time = wave.scene.probes.computed.time;
  const TwoPartWave exact(bar, time.back());
  for (const double x : {place_a, place_wall, place_b}) {
    auto& history = wave.exact.emplace_back();
    for (const double t : time) history.push_back(exact.stress(x, t));
  }
  run.table(label + "-exact", {"time", "p1.pk1_xx", "p2.pk1_xx", "p3.pk1_xx"},
            {time, wave.exact[0], wave.exact[1], wave.exact[2]});
  return wave;
}

/// Figs 4.16 and 4.17: the coefficients of (4.45) and (4.46).
void partial_transmission(CaseRun& run) {
  for (const auto& [ratio, name, figure] : {std::tuple{1.0 / 16.0, "1-16", "thesis, Fig. 4.16"},
                                            {1.0 / 4.0, "1-4", "thesis, Fig. 4.16"},
                                            {4.0, "4", "thesis, Fig. 4.17"},
                                            {16.0, "16", "thesis, Fig. 4.17"}})
    for (const std::string& formulation : formulations) {
      const TwoPartBar bar = bar_of(ratio, true);
      const Wave wave =
          run_wave(run, fmt::format("{}-{}", formulation, name),
                   {"formulation=" + formulation,
                    fmt::format("material.region[0].density={}", ratio * validation_bar::density)},
                   bar);
      const double through_b = (validation_bar::length - interface) / bar.speed_b;
      const std::string of = fmt::format(", density × {}, {}", ratio, formulation);
      run.relative(figure, "reflected stress C_r" + of, bar.reflected(),
                   wave.share("p1", (2.0 * interface - place_a) / bar.speed_a, 2.0 * through_b),
                   within(formulation));
      run.relative(figure, "transmitted stress C_t" + of, bar.transmitted(),
                   wave.share("p3", interface / bar.speed_a + (place_b - interface) / bar.speed_b,
                              through_b),
                   within(formulation));
      run.report("rays", "relative L2 error of stress at 0.1125 m" + of, wave.error("p3", 2));
    }
}

/// Figs 4.18 and 4.19: the right half as a wall, and as nothing.
void extremes(CaseRun& run) {
  for (const std::string& formulation : formulations) {
    const TwoPartBar wall = bar_of(1e8, true);
    const Wave heavy =
        run_wave(run, formulation + "-heavy",
                 {"formulation=" + formulation, "material.region[0].density=8e11"}, wall);
    const std::string of = ", " + formulation;
    const double there = interface / wall.speed_a;
    run.relative("thesis, Fig. 4.18", "reflected stress C_r, density × 1e8" + of, wall.reflected(),
                 heavy.share("p1", 2.0 * there - place_a / wall.speed_a, 1.0), within(formulation));
    run.relative("thesis, (4.46)", "stress before the interface, density × 1e8" + of,
                 wall.transmitted(), heavy.share("p2", there, 1.0), within(formulation));
    const double scale = validation_bar::pressure * pulse.duration /
                         (validation_bar::density * validation_bar::speed);
    run.at_most(
        "thesis, Fig. 4.18", "displacement of the interface / that of the wave, density × 1e8" + of,
        1e-3, peak(heavy.time(), heavy.scene.probe("interface.displacement_x"), 0.0, 1.0) / scale);

    // With a free right end: held there, a light bar would be a spring, not nothing.
    const TwoPartBar nothing = bar_of(1e-4, false);
    const Wave light = run_wave(
        run, formulation + "-light",
        {"formulation=" + formulation, "material.region[0].density=0.8", "body.spacing=5e-4",
         "time.end=40e-6", "output.probe_every=40",
         R"(boundary=[{ where = "left", traction = { curve = "pulse", amplitude = -100e3, duration = 5e-6, rise = 0.6e-6 } }])"},
        nothing);
    run.relative("thesis, Fig. 4.19", "reflected stress, density × 1e-4" + of, -1.0,
                 light.share("p1", 2.0 * there - place_a / wall.speed_a, 1.0), within(formulation));
    run.report("rays", "relative L2 error of stress at 0.0375 m, density × 1e-4" + of,
               light.error("p1", 0));
  }
}

}  // namespace

void impedance(CaseRun& run) {
  partial_transmission(run);
  extremes(run);
}

}  // namespace tlsph

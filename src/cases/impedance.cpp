// A density change at midspan: what of a pulse comes back from it, what goes on; against the exact
// solution, every ray that the interface and the ends make of the pulse.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <compare>
#include <map>
#include <tuple>

#include "list.hpp"
#include "samples.hpp"
#include "validation_bar.hpp"

namespace tlsph {
namespace {

constexpr PulseCurve pulse{-validation_bar::pressure, 5e-6, 0.6e-6};
constexpr double interface = 0.5 * validation_bar::length;
constexpr double place_a = 0.0375;  // of the probes [m]
constexpr double place_b = 0.1125;
constexpr double place_wall = 0.074;        // close to the interface, in the material that is there
constexpr double flank = 2.4 * pulse.rise;  // (1 − erf)/2 is 3e-4 after it
using validation_bar::formulations;

/// A bar from 0 to `length`, loaded at 0 from rest. Part A ends at `interface`, where part B
/// begins; all in SI units.
struct TwoPartBar {
  double interface = 0.0, length = 0.0;
  double speed_a = 0.0, speed_b = 0.0;  ///< [m/s]
  double impedance_ratio = 1.0;         ///< ρ_B c_B / ρ_A c_A
  bool fixed_end = true;                ///< else free
  Curve traction;                       ///< at 0 [Pa]

  /// (4.45) of the thesis: the stress sent back over the stress that comes, from A.
  [[nodiscard]] double reflected() const { return (impedance_ratio - 1) / (impedance_ratio + 1); }
  /// (4.46): the stress that goes on into B.
  [[nodiscard]] double transmitted() const { return 2 * impedance_ratio / (impedance_ratio + 1); }
};

/// The stress of a TwoPartBar until a given time.
class TwoPartWave {
 public:
  /// Follows all rays that set out before `end` [s].
  TwoPartWave(const TwoPartBar& bar, double end);
  /// P [Pa] at the place x [m] and time t ≤ end [s].
  [[nodiscard]] double stress(double x, double t) const;

 private:
  struct Ray {
    bool in_b, outward;
    double start;   // when it sets out from its end of its part [s]
    double factor;  // of the traction
  };
  TwoPartBar bar_;
  std::vector<Ray> rays_;
};

TwoPartWave::TwoPartWave(const TwoPartBar& bar, double end) : bar_(bar) {
  const double through_a = bar.interface / bar.speed_a;
  const double through_b = (bar.length - bar.interface) / bar.speed_b;
  const double back = bar.reflected();
  const double on = bar.transmitted();
  // Rays that have gone through A and B as often set out together, so their factors add up. In the
  // order of the ways behind them, none gets a share after it was followed.
  struct Key {
    int ways, ways_in_a;
    bool in_b, outward;
    // NOLINTNEXTLINE(modernize-use-nullptr): a comparison with zero that the compiler writes
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, double> waiting = {{{0, 0, false, true}, 1.0}};
  while (!waiting.empty()) {
    const auto [key, factor] = *waiting.begin();
    waiting.erase(waiting.begin());
    const auto [ways, in_a, in_b, outward] = key;
    const double start = in_a * through_a + (ways - in_a) * through_b;
    if (start > end) continue;
    rays_.push_back({in_b, outward, start, factor});
    const int next_in_a = in_a + (in_b ? 0 : 1);
    const auto send = [&, ways = ways, factor = factor](bool into_b, bool out, double share) {
      waiting[{ways + 1, next_in_a, into_b, out}] += share * factor;
    };
    if (!in_b && !outward) {
      send(false, true, -1.0);  // the loaded end is free for what comes back to it
    } else if (in_b && outward) {
      send(true, false, bar.fixed_end ? 1.0 : -1.0);
    } else if (!in_b) {
      send(false, false, back);
      send(true, true, on);
    } else {
      send(true, true, -back);
      send(false, false, 2.0 - on);  // (4.46) from B: 2/(1 + ratio)
    }
  }
}

double TwoPartWave::stress(double x, double t) const {
  const bool in_b = x > bar_.interface;
  const double from = in_b ? x - bar_.interface : x;
  const double to = in_b ? bar_.length - x : bar_.interface - x;
  const double speed = in_b ? bar_.speed_b : bar_.speed_a;
  double sum = 0.0;
  for (const Ray& ray : rays_)
    if (ray.in_b == in_b)
      sum += ray.factor * value(bar_.traction, t - ray.start - (ray.outward ? from : to) / speed);
  return sum;
}

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

/// A run, its exact solution that of the rays in `bar`.
CaseScene run_wave(CaseRun& run, const std::string& label, const Settings& settings,
                   const TwoPartBar& bar) {
  CaseScene wave = run.scene(label, "bar.toml", settings);
  const TwoPartWave exact(bar, wave.history.time.back());
  std::vector<CaseColumn> table = {{"time", wave.history.time}};
  wave.exact.time = wave.history.time;
  for (const auto& [name, x] : {std::pair{"p1.pk1_xx", place_a}, std::pair{"p2.pk1_xx", place_wall},
                                std::pair{"p3.pk1_xx", place_b}}) {
    CaseColumn& stress = table.emplace_back(name);
    for (const double t : wave.exact.time) stress.values.push_back(exact.stress(x, t));
    wave.exact.names.push_back(stress.name);
    wave.exact.values.push_back(stress.values);
  }
  run.table(label + "-exact", table);
  return wave;
}

/// The mean stress over the load's, while the plateau of a ray passes that set out at `start` and
/// is alone for `alone` seconds.
double share(const Samples& stress, double start, double alone) {
  const double front = 3.0 * pulse.rise + start;
  return mean(stress, front + flank, front + std::min(pulse.duration, alone) - flank) /
         pulse.amplitude;
}

/// Figs 4.16 and 4.17: the coefficients of (4.45) and (4.46).
void partial_transmission(CaseRun& run) {
  for (const auto& [ratio, name, figure] : {std::tuple{1.0 / 16.0, "1-16", "thesis, Fig. 4.16"},
                                            {1.0 / 4.0, "1-4", "thesis, Fig. 4.16"},
                                            {4.0, "4", "thesis, Fig. 4.17"},
                                            {16.0, "16", "thesis, Fig. 4.17"}})
    for (const std::string formulation : formulations) {
      const TwoPartBar bar = bar_of(ratio, true);
      const CaseScene wave =
          run_wave(run, fmt::format("{}-{}", formulation, name),
                   {"formulation=" + formulation,
                    fmt::format("material.region[0].density={}", ratio * validation_bar::density)},
                   bar);
      const double through_b = (validation_bar::length - interface) / bar.speed_b;
      const Checks check(run, fmt::format(", density × {}, {}", ratio, formulation));
      check(figure, "reflected stress C_r",
            share(wave.samples("p1.pk1_xx"), (2.0 * interface - place_a) / bar.speed_a,
                  2.0 * through_b),
            relative(bar.reflected(), within(formulation)));
      check(figure, "transmitted stress C_t",
            share(wave.samples("p3.pk1_xx"),
                  interface / bar.speed_a + (place_b - interface) / bar.speed_b, through_b),
            relative(bar.transmitted(), within(formulation)));
      check("rays", "relative L2 error of stress at 0.1125 m", relative_error(wave, "p3.pk1_xx"),
            reported());
    }
}

/// Figs 4.18 and 4.19: the right half as a wall, and as nothing.
void extremes(CaseRun& run) {
  for (const std::string formulation : formulations) {
    const TwoPartBar wall = bar_of(1e8, true);
    const CaseScene heavy =
        run_wave(run, formulation + "-heavy",
                 {"formulation=" + formulation, "material.region[0].density=8e11"}, wall);
    const Checks check(run, ", " + formulation);
    const double there = interface / wall.speed_a;
    check("thesis, Fig. 4.18", "reflected stress C_r, density × 1e8",
          share(heavy.samples("p1.pk1_xx"), 2.0 * there - place_a / wall.speed_a, 1.0),
          relative(wall.reflected(), within(formulation)));
    check("thesis, (4.46)", "stress before the interface, density × 1e8",
          share(heavy.samples("p2.pk1_xx"), there, 1.0),
          relative(wall.transmitted(), within(formulation)));
    const double scale = validation_bar::pressure * pulse.duration /
                         (validation_bar::density * validation_bar::speed);
    check("thesis, Fig. 4.18", "displacement of the interface / that of the wave, density × 1e8",
          peak(heavy.samples("interface.displacement_x")) / scale, at_most(1e-3));

    // With a free right end: held there, a light bar would be a spring, not nothing.
    const TwoPartBar nothing = bar_of(1e-4, false);
    const CaseScene light = run_wave(
        run, formulation + "-light",
        {"formulation=" + formulation, "material.region[0].density=0.8", "body.spacing=5e-4",
         "time.end=40e-6", "output.probe_every=40",
         R"(boundary=[{ where = "left", traction = { curve = "pulse", amplitude = -100e3, duration = 5e-6, rise = 0.6e-6 } }])"},
        nothing);
    check("thesis, Fig. 4.19", "reflected stress, density × 1e-4",
          share(light.samples("p1.pk1_xx"), 2.0 * there - place_a / wall.speed_a, 1.0),
          relative(-1.0, within(formulation)));
    check("rays", "relative L2 error of stress at 0.0375 m, density × 1e-4",
          relative_error(light, "p1.pk1_xx"), reported());
  }
}

}  // namespace

void impedance(CaseRun& run) {
  partial_transmission(run);
  extremes(run);
}

}  // namespace tlsph

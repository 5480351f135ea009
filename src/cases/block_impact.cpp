// Two bonded blocks that meet: the kinetic energy over time is a triangle, unless the sides are
// free.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "list.hpp"
#include "samples.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/contrast/growth.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

constexpr double young = 1.5e6;  // [Pa]
constexpr double poisson = 0.49;
constexpr double density = 1200.0;  // [kg/m³]
constexpr double length = 1.0;      // of a block [m]

double speed() {
  return wave_speed(p_modulus(1, Assumption::strain, young, poisson), density);
}
/// Until the waves from the joint have gone to the free ends and back [s].
double cycle() {
  return 2.0 * length / speed();
}
/// The wave from the joint stops the blocks as it passes; its echo throws them back.
double triangle(double t) {
  const double turns = t / cycle();
  return std::abs(1.0 - 2.0 * (turns - std::floor(turns)));
}

EnergyHistory read_energy(const CaseScene& scene) {
  EnergyHistory kinetic = {scene.data("series/time"), scene.data("series/kinetic")};
  const double first = kinetic.energy.front();
  for (double& value : kinetic.energy) value /= first;
  return kinetic;
}

void write(const CaseRun& run, const std::string& name, const EnergyHistory& kinetic) {
  run.table(name, {{"time", kinetic.time}, {"energy", kinetic.energy}});
}

/// Root mean square distance from the triangle between two instants, in cycles.
double distance(const EnergyHistory& kinetic, double from = 0.0, double to = 1.0) {
  double sum = 0.0, span = 0.0;
  for (std::size_t k = 1; k < kinetic.time.size(); ++k) {
    if (kinetic.time[k] <= from * cycle() || kinetic.time[k] > to * cycle()) continue;
    const double dt = kinetic.time[k] - kinetic.time[k - 1];
    sum += dt * std::pow(kinetic.energy[k] - triangle(kinetic.time[k]), 2);
    span += dt;
  }
  return std::sqrt(sum / span);
}

/// When the falling and the rising line through the energy meet, each fitted where it is between
/// 0.2 and 0.8 of the first: the minimum, without the ripples around it [s].
double first_minimum(const EnergyHistory& kinetic) {
  const auto falls = static_cast<std::size_t>(
      std::ranges::find_if(kinetic.energy, [](double value) { return value < 0.1; }) -
      kinetic.energy.begin());
  const auto fit = [&](std::size_t from, std::size_t to) {
    std::vector<double> time, energy;
    for (std::size_t k = from; k < to; ++k) {
      if (kinetic.energy[k] < 0.2 || kinetic.energy[k] > 0.8) continue;
      time.push_back(kinetic.time[k]);
      energy.push_back(kinetic.energy[k]);
    }
    return fit_line(time, energy);
  };
  std::size_t turn = falls;
  while (turn < kinetic.time.size() && kinetic.time[turn] < 0.9 * cycle()) ++turn;
  const LineFit down = fit(0, falls);
  const LineFit up = fit(falls, turn);
  return (down.intercept - up.intercept) / (up.slope - down.slope);
}

EnergyHistory plane_wave(CaseRun& run, const std::string& formulation, int n) {
  constexpr const char* source = "Cranfield thesis, Fig. 3-7";
  const std::string label = fmt::format("{}-{}", formulation, n);
  Settings settings = {"formulation=" + formulation,
                       fmt::format("body.spacing={:.17g}", 2.0 * length / n)};
  if (formulation == "variational") settings.emplace_back("body.placement=cell-centred");
  const EnergyHistory kinetic = read_energy(run.scene(label, "blocks.toml", settings));
  const bool thesis = formulation == "thesis";
  const Checks check(run, fmt::format(", n = {}, {}", n, formulation));
  const double limit = n == 80 ? 0.01 : 0.004;
  check(source, "distance of the energy from the triangle, rms", distance(kinetic),
        thesis ? reported(limit) : at_most(limit));
  const double expected = 1e3 * length / speed();
  check(source, "first minimum of the kinetic energy [ms]", 1e3 * first_minimum(kinetic),
        thesis ? reported(expected) : relative(expected, 2e-3));
  write(run, label, kinetic);
  return kinetic;
}

/// The sheet with its sides held is the bar; with free sides nothing is a triangle.
void sheets(CaseRun& run) {
  constexpr const char* source = "Cranfield thesis, Figs 3-7, 6-3";
  const EnergyHistory held = read_energy(
      run.scene("sheet-held", "sheet.toml",
                {R"(boundary=[{where="bottom", symmetry=true}, {where="top", symmetry=true}])",
                 "output.frames=0"}));
  const EnergyHistory bar =
      read_energy(run.scene("bar-same-steps", "blocks.toml", {"time.step=8e-5"}));
  run.check(source, "plane strain with its sides held against the bar, kinetic energy",
            largest_difference(bar.energy, held.energy), at_most(1e-9));

  const EnergyHistory free = read_energy(run.scene("sheet-free", "sheet.toml"));
  run.check(source, "distance of the energy from the triangle, rms, free sides, stress-point",
            distance(free), reported(0.0));
  write(run, "sheet-free", free);
}

/// The counter-example, and the same blocks in total-Lagrangian form.
void tension(CaseRun& run, const EnergyHistory& total) {
  constexpr const char* source = "Cranfield thesis, Figs 3-6, 3-7";
  constexpr int n = 80;
  constexpr double spacing = 2.0 * length / n;
  const double modulus = density * speed() * speed();
  CurrentRun<1> blocks = current_lattice<1>(
      {CubicSpline{}, 2.4 * spacing, spacing, {modulus, 0.0}, density, 0.0}, {n}, 0);
  blocks.state.v.topRows(n / 2).setConstant(1.0);
  blocks.state.v.bottomRows(n / 2).setConstant(-1.0);
  VectorField<1> stretched;  // the particles under the largest tension
  EnergyHistory updated = step_until<1>(blocks, 0.2 * spacing / speed(), 3.0 * cycle(),
                                        [&](const CurrentState<1>& state) {
                                          if (state.time < 1.5 * cycle()) stretched = state.x;
                                        });
  updated.time.insert(updated.time.begin(), 0.0);
  updated.energy.insert(updated.energy.begin(), 1.0);
  const auto compare = [&](const char* name, const EnergyHistory& kinetic, const Claim& claim) {
    run.check(
        source,
        fmt::format("distance from the triangle, rms in the second and third cycle, {}", name),
        distance(kinetic, 1.0, 3.0), claim);
  };
  compare("updated", updated, at_least(0.1));
  compare("stress-point", total, at_most(0.01));
  write(run, "updated", updated);
  run.table("positions", {{"x", stretched}});
}

}  // namespace

void block_impact(CaseRun& run) {
  const EnergyHistory total = plane_wave(run, "stress-point", 80);
  plane_wave(run, "stress-point", 320);
  for (const char* formulation : {"variational", "mirror", "thesis"})
    for (const int n : {80, 320}) plane_wave(run, formulation, n);
  sheets(run);
  tension(run, total);
}

}  // namespace tlsph

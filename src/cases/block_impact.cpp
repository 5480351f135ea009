// Two bonded blocks that meet: the kinetic energy over time is a triangle, unless the sides are
// free.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "list.hpp"
#include "run_series.hpp"
#include "tlsph/contrast/current_lattice.hpp"
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

/// The kinetic energy over the first.
RunSeries read_energy(const std::filesystem::path& directory) {
  RunSeries kinetic = read_series(directory, "kinetic");
  const double first = kinetic.values.front();
  for (double& value : kinetic.values) value /= first;
  return kinetic;
}

/// Root mean square distance from the triangle between two instants, in cycles.
double distance(const RunSeries& kinetic, double from = 0.0, double to = 1.0) {
  double sum = 0.0, span = 0.0;
  for (std::size_t k = 1; k < kinetic.time.size(); ++k) {
    if (kinetic.time[k] <= from * cycle() || kinetic.time[k] > to * cycle()) continue;
    const double dt = kinetic.time[k] - kinetic.time[k - 1];
    sum += dt * std::pow(kinetic.values[k] - triangle(kinetic.time[k]), 2);
    span += dt;
  }
  return std::sqrt(sum / span);
}

/// When the falling and the rising line through the energy meet, each fitted where it is between
/// 0.2 and 0.8 of the first: the minimum, without the ripples around it [s].
double first_minimum(const RunSeries& kinetic) {
  const auto falls = static_cast<std::size_t>(
      std::ranges::find_if(kinetic.values, [](double value) { return value < 0.1; }) -
      kinetic.values.begin());
  const auto fit = [&](std::size_t from, std::size_t to) {
    double n = 0.0, t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
    for (std::size_t k = from; k < to; ++k) {
      if (kinetic.values[k] < 0.2 || kinetic.values[k] > 0.8) continue;
      n += 1.0;
      t += kinetic.time[k];
      y += kinetic.values[k];
      tt += kinetic.time[k] * kinetic.time[k];
      ty += kinetic.time[k] * kinetic.values[k];
    }
    const double slope = (n * ty - t * y) / (n * tt - t * t);
    return std::pair{slope, (y - slope * t) / n};
  };
  std::size_t turn = falls;
  while (turn < kinetic.time.size() && kinetic.time[turn] < 0.9 * cycle()) ++turn;
  const auto [down, top] = fit(0, falls);
  const auto [up, bottom] = fit(falls, turn);
  return (top - bottom) / (up - down);
}

void plane_wave(CaseRun& run, const std::string& formulation, int n) {
  std::vector<std::string> overrides = {"formulation=" + formulation,
                                        fmt::format("body.spacing={:.17g}", 2.0 * length / n)};
  if (formulation == "variational") overrides.emplace_back("body.placement=cell-centred");
  const RunSeries kinetic = read_energy(
      run.scene(fmt::format("{}-{}", formulation, n), "blocks.toml", overrides).directory);
  const std::string of = fmt::format("n = {}, {}", n, formulation);
  const double limit = n == 80 ? 0.01 : 0.004;
  const std::string distance_text = "distance of the energy from the triangle, rms, " + of;
  const std::string time_text = fmt::format("first minimum of the kinetic energy, {} [ms]", of);
  constexpr const char* source = "Cranfield thesis, Fig. 3-7";
  if (formulation == "thesis") {
    run.report(source, distance_text, distance(kinetic), limit);
    run.report(source, time_text, 1e3 * first_minimum(kinetic), 1e3 * length / speed());
  } else {
    run.at_most(source, distance_text, limit, distance(kinetic));
    run.relative(source, time_text, 1e3 * length / speed(), 1e3 * first_minimum(kinetic), 2e-3);
  }
  run.table(fmt::format("{}-{}", formulation, n), {"time", "energy"},
            {kinetic.time, kinetic.values});
}

/// The sheet with its sides held is the bar; with free sides nothing is a triangle.
void sheets(CaseRun& run) {
  constexpr const char* source = "Cranfield thesis, Figs 3-7, 6-3";
  const RunSeries held = read_energy(
      run.scene("sheet-held", "sheet.toml",
                {R"(boundary=[{where="bottom", symmetry=true}, {where="top", symmetry=true}])",
                 "output.frames=0"})
          .directory);
  const RunSeries bar =
      read_energy(run.scene("bar-same-steps", "blocks.toml", {"time.step=8e-5"}).directory);
  double apart = 0.0;
  for (std::size_t k = 0; k < bar.values.size(); ++k)
    apart = std::max(apart, std::abs(bar.values[k] - held.values.at(k)));
  run.at_most(source, "plane strain with its sides held against the bar, kinetic energy", 1e-9,
              apart);

  const RunSeries free = read_energy(run.scene("sheet-free", "sheet.toml").directory);
  run.report(source, "distance of the energy from the triangle, rms, free sides, stress-point",
             distance(free), 0.0);
  run.table("sheet-free", {"time", "energy"}, {free.time, free.values});
}

/// The counter-example: its kinetic energy, and where its particles are under the largest tension.
struct Updated {
  RunSeries kinetic;
  VectorField<1> x;
};

Updated updated_lagrangian(int n) {
  const double spacing = 2.0 * length / n;
  const double modulus = density * speed() * speed();
  auto [body, state] = current_lattice<1>(
      {CubicSpline{}, 2.4 * spacing, spacing, {modulus, 0.0}, density, 0.0}, {n}, 0);
  state.v.topRows(n / 2).setConstant(1.0);
  state.v.bottomRows(n / 2).setConstant(-1.0);
  const double first = kinetic_energy<1>(body, state);
  const double dt = 0.2 * spacing / speed();
  Updated updated{{{0.0}, {1.0}}, state.x};
  while (state.time < 3.0 * cycle()) {
    advance<1>(body, state, dt);
    updated.kinetic.time.push_back(state.time);
    updated.kinetic.values.push_back(kinetic_energy<1>(body, state) / first);
    if (state.time < 1.5 * cycle()) updated.x = state.x;
  }
  return updated;
}

void tension(CaseRun& run) {
  constexpr const char* source = "Cranfield thesis, Figs 3-6, 3-7";
  const Updated updated = updated_lagrangian(80);
  const RunSeries total = read_energy(run.out() / "stress-point-80");
  run.at_least(source, "distance from the triangle, rms in the second and third cycle, updated",
               0.1, distance(updated.kinetic, 1.0, 3.0));
  run.at_most(source, "distance from the triangle, rms in the second and third cycle, stress-point",
              0.01, distance(total, 1.0, 3.0));
  run.table("updated", {"time", "energy"}, {updated.kinetic.time, updated.kinetic.values});
  run.table("positions", {"x"}, {{updated.x.begin(), updated.x.end()}});
}

}  // namespace

void block_impact(CaseRun& run) {
  for (const char* formulation : {"stress-point", "variational", "mirror", "thesis"})
    for (const int n : {80, 320}) plane_wave(run, formulation, n);
  sheets(run);
  tension(run);
}

}  // namespace tlsph

// Swegle's test: a body under uniform stress must stay as it is, and in tension the kernel sums of
// the current configuration do not let it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "list.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/contrast/growth.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/stepping/stepper.hpp"

namespace tlsph {
namespace {

constexpr double spacing = 1e-3;          // [m]
constexpr double density = 1000.0;        // [kg/m³]
constexpr double speed = 1500.0;          // c [m/s], of the longitudinal wave
constexpr double push = 1e-6;             // [m/s], of the particle in the middle
constexpr double strain = 0.035;          // both ways; the stress is 0.05 ρc²
constexpr double ratio = 0.05;            // σ₀/(ρc²)
constexpr double unit = spacing / speed;  // Δ/c [s]
constexpr std::array sheet_counts = {25, 25};
constexpr int held = 3;  // layers, so that every free particle has all its neighbours

constexpr const char* still = "Cranfield thesis, Fig. 3-4";
constexpr const char* grows = "Cranfield thesis, Fig. 3-5";

/// The particle that is pushed, all the kinetic energy there is [J/m].
constexpr double first_energy = 0.5 * density * spacing * spacing * push * push;

std::string rollers(double stretch) {
  const double move = 24.0 * spacing * stretch;
  return fmt::format(
      R"(boundary=[{{where="left", fixed="x"}}, {{where="bottom", fixed="y"}}, )"
      R"({{where="right", displacement={{x={0}}}}}, {{where="top", displacement={{y={0}}}}}])",
      move);
}

std::vector<std::pair<std::string, Settings>> formulations(double stretch) {
  const std::string layers = R"(boundary=[{where="west", held=true}, {where="east", held=true}, )"
                             R"({where="south", held=true}, {where="north", held=true}])";
  const std::string kernel = R"(kernel={family="cubic-spline", support=2.4})";
  const std::string bare = R"(kernel={family="cubic-spline", support=2.4, correction="none"})";
  return {{"stress-point", {}},
          {"variational", {"formulation=variational", kernel, layers}},
          {"uncorrected", {"formulation=variational", bare, "stabiliser.kind=none", layers}},
          {"mirror", {"formulation=mirror", kernel, rollers(stretch)}},
          {"thesis", {"formulation=thesis", kernel, rollers(stretch)}}};
}

/// A table of every n-th row.
std::vector<CaseColumn> thinned(std::vector<CaseColumn> table, std::size_t n) {
  for (CaseColumn& column : table) {
    std::vector<double> kept;
    for (std::size_t k = 0; k < column.values.size(); k += n) kept.push_back(column.values[k]);
    column.values = std::move(kept);
  }
  return table;
}

/// Every formulation at one stretch; the energy over time goes to total-<name>.csv.
void total_lagrangian(CaseRun& run, const char* name, double stretch) {
  const std::string initial =
      fmt::format("initial.displacement={{gradient=[[{0}, 0.0], [0.0, {0}]]}}", stretch);
  std::vector<CaseColumn> table;
  for (const auto& [formulation, settings] : formulations(stretch)) {
    const CaseScene scene =
        run.scene(fmt::format("{}-{}", formulation, name), "sheet.toml", with(settings, {initial}));
    if (table.empty()) table.emplace_back("time", scene.data("series/time"));
    CaseColumn& kinetic = table.emplace_back(formulation, scene.data("series/kinetic"));
    for (double& energy : kinetic.values) energy /= first_energy;
    // Its ghosts are solved for, and do not keep a uniform stretch uniform at a moved edge.
    const Claim claim = formulation == "thesis" ? reported() : at_most(1.001);
    run.check(
        still,
        fmt::format("largest kinetic energy over the first, 10 000 steps in {}, {}", name,
                    formulation == "uncorrected" ? "variational without correction" : formulation),
        std::ranges::max(kinetic.values), claim);
  }
  run.table(fmt::format("total-{}", name), thinned(table, 4));
}

/// What bare clamped edges do to a collocated formulation: scenes refuse it, so the run is made
/// here.
void thin_layers(CaseRun& run) {
  const Scene scene = run.read(
      "sheet.toml", {"formulation=variational", R"(kernel={family="cubic-spline", support=2.4})"});
  const auto body = build<2>(scene);
  double refused = 0.0;
  try {
    (void)build_initial<2>(scene, body);
  } catch (const InputError&) {
    refused = 1.0;
  }
  run.check("this project", "scene with bare clamped edges, variational, is refused (1: yes)",
            refused, absolute(1.0, 0.0));

  Stepper<2> stepper(body, strain * body.particles.X, VectorField<2>::Zero(body.nodes(), 2),
                     {.step = 3e-8, .sweep = false, .balance_every = 0});
  double largest = 0.0;
  for (int step = 0; step < 1000; ++step) {
    stepper.step();
    largest = std::max(largest, 0.5 * body.mass.dot(stepper.state().v.rowwise().squaredNorm()));
  }
  run.check("this project", "kinetic energy over the first that it would have had",
            largest / first_energy, reported());
}

template <int D>
StressedLattice<D> current(double stress_ratio) {
  constexpr double modulus = density * speed * speed;    // λ + 2μ
  const double mu = D == 1 ? 0.0 : modulus * 0.4 / 1.4;  // ν = 0.3
  return {CubicSpline{}, 2.4 * spacing,         spacing, {modulus - 2.0 * mu, mu},
          density,       stress_ratio * modulus};
}

/// The counter-example until `end`; its last positions go to `x`.
template <int D>
EnergyHistory updated_lagrangian(double stress_ratio, const std::array<int, D>& counts, double end,
                                 VectorField<D>* x = nullptr) {
  CurrentRun<D> run = current_lattice<D>(current<D>(stress_ratio), counts, held);
  run.state.v(run.state.v.rows() / 2, 0) = push;
  return step_until<D>(run, 0.05 * unit, end, [x](const CurrentState<D>& state) {
    if (x != nullptr) *x = state.x;
  });
}

/// Half the rate of the energy, between 10⁶ and 10¹² times the first.
double rate_of(const EnergyHistory& growth) {
  return 0.5 * growth_rate(growth.time, growth.energy, 1e6, 1e12) * unit;
}

void stress_levels(CaseRun& run) {
  std::vector<CaseColumn> table = {
      {"stress"}, {"theory_1d"}, {"measured_1d"}, {"theory_2d"}, {"measured_2d"}};
  for (const double s : {0.0125, 0.025, 0.05, 0.1}) {
    const double line = fastest_growth<1>(current<1>(s)).rate * unit;
    const double sheet =
        linear_growth_rate(current_lattice<2>(current<2>(s), sheet_counts, held)) * unit;
    const double end = 20.0 * unit / line;
    const double line_seen = rate_of(updated_lagrangian<1>(s, {201}, end));
    const double sheet_seen = rate_of(updated_lagrangian<2>(s, sheet_counts, end));
    const Checks check(run, fmt::format(", stress {:g} ρc², updated Lagrangian", s));
    check(grows, "growth rate, 1D [c/Δ]", line_seen, relative(line, 0.03));
    check(grows, "growth rate, 25 × 25 [c/Δ]", sheet_seen, relative(sheet, 0.03));
    add_row(table, {s, line, line_seen, sheet, sheet_seen});
  }
  run.check(grows, "growth rate, 2D, stress 0.05 ρc², unbounded lattice, by its symbol [c/Δ]",
            fastest_growth<2>(current<2>(ratio)).rate * unit, reported());
  run.table("rates", table);
}

}  // namespace

void swegle(CaseRun& run) {
  total_lagrangian(run, "tension", strain);
  total_lagrangian(run, "compression", -strain);
  thin_layers(run);
  stress_levels(run);

  VectorField<2> clumps;
  const EnergyHistory tension = updated_lagrangian<2>(ratio, sheet_counts, 72.0 * unit, &clumps);
  const EnergyHistory compression = updated_lagrangian<2>(-ratio, sheet_counts, 150.0 * unit);
  run.check(grows, "kinetic energy over the first at t = 40 Δ/c in tension, updated Lagrangian",
            tension.energy.at(799), at_least(1e6));
  run.check("Cranfield thesis, sec. 3.3.1",
            "largest kinetic energy over the first in compression, updated Lagrangian",
            std::ranges::max(compression.energy), at_most(1.001));
  for (const auto& [name, growth] :
       {std::pair{"updated-tension", &tension}, {"updated-compression", &compression}})
    run.table(name, thinned({{"time", growth->time}, {"energy", growth->energy}}, 10));
  run.table("clumps", {{"x", clumps.col(0)}, {"y", clumps.col(1)}});
}

}  // namespace tlsph

// The first period of a clamped plate, from the eigenvalue of its operators and from a run.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "linear_body.hpp"
#include "list.hpp"
#include "tlsph/analysis/oscillation.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

constexpr double height = 0.02;
/// First period in two-dimensional elasticity at small amplitude [s]; thin beams have 0.2540 s.
constexpr double exact_period = 0.25523;
/// Particles through the thickness, those on both faces counted.
constexpr std::array particles = {5, 10, 20};

/// Operators, and how far their period may be from the exact one [relative]; zero: reported.
struct Method {
  const char* name;
  std::vector<std::string> overrides;
  std::array<double, particles.size()> within;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      {"consistent (2, 1), pair stabiliser", {}, {2.5e-3, 5e-4, 1e-4}},
      {"variational, order 2, support 2.6, pair stabiliser",
       {"formulation=variational", "kernel.order=2", "kernel.support=2.6"},
       {0.06, 9e-3, 1e-3}},
      {"stress-point, cell stabiliser",
       {"formulation=stress-point", "stabiliser.kind=cell"},
       {4e-3, 2e-3, 1e-3}},
      {"variational, order 1, pair stabiliser", {"formulation=variational"}, {}},
      {"consistent (1, 1), pair stabiliser", {"consistency=[1, 1]"}, {}}};
  return list;
}

double period(const CaseRun& run, std::vector<std::string> overrides, int through) {
  overrides.push_back(fmt::format("body.spacing={}", height / (through - 1)));
  const Discretisation<2> disc = build<2>(run.read("plate.toml", overrides));
  return 2 * std::numbers::pi / LinearBody(disc).lowest_frequency();
}

/// The same operators stepped: the mean, for the initial field is not quite the mode.
double period_of_run(CaseRun& run, int through) {
  const CaseScene swing =
      run.scene("swing", "plate.toml", {fmt::format("body.spacing={}", height / (through - 1))});
  return mean_period(swing.probes.computed.time, swing.probe("tip.displacement_y"));
}

}  // namespace

void beam_period(CaseRun& run) {
  constexpr const char* source = "plane elasticity, small amplitude";
  std::vector<std::string> columns = {"particles"};
  std::vector<std::vector<double>> values = {{particles.begin(), particles.end()}};
  for (const Method& method : methods()) {
    columns.emplace_back(method.name);
    values.emplace_back();
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const double seen = period(run, method.overrides, particles.at(k));
      values.back().push_back(seen / exact_period - 1);
      const std::string text =
          fmt::format("error of the first period [%], {} particles through the thickness, {}",
                      particles.at(k), method.name);
      if (method.within[k] > 0.0)
        run.absolute(source, text, 0.0, 100 * values.back().back(), 100 * method.within[k]);
      else
        run.report(source, text, 100 * values.back().back(), 0.0);
    }
  }
  run.absolute(source,
               "error of the first period [%], 10 particles, consistent (2, 1), three periods of "
               "a run",
               0.0, 100 * (period_of_run(run, 10) / exact_period - 1), 0.2);
  run.table("periods", columns, values);
}

}  // namespace tlsph

// The first period of a clamped plate, from the eigenvalue of its operators and from a run.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "linear_body.hpp"
#include "list.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

constexpr double height = 0.02;
/// First period in two-dimensional elasticity at small amplitude [s]; thin beams have 0.2540 s.
constexpr double exact_period = 0.25523;
/// Particles through the thickness, those on both faces counted.
constexpr std::array particles = {5, 10, 20};

/// The error of the first period is within so much [%]; zero where it is only reported.
struct Method {
  const char* name;
  Settings settings;
  std::array<double, particles.size()> within;
};

const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      {"consistent (2, 1), pair stabiliser", {}, {0.25, 0.05, 0.01}},
      {"variational, order 2, support 2.6, pair stabiliser",
       {"formulation=variational", "kernel.order=2", "kernel.support=2.6"},
       {6.0, 0.9, 0.1}},
      {"stress-point, cell stabiliser",
       {"formulation=stress-point", "stabiliser.kind=cell"},
       {0.4, 0.2, 0.1}},
      {"variational, order 1, pair stabiliser", {"formulation=variational"}, {}},
      {"consistent (1, 1), pair stabiliser", {"consistency=[1, 1]"}, {}}};
  return list;
}

std::string spacing(int through) {
  return fmt::format("body.spacing={}", height / (through - 1));
}

double period(const CaseRun& run, const Settings& settings, int through) {
  const auto body = build<2>(run.read("plate.toml", with(settings, {spacing(through)})));
  return 2 * std::numbers::pi / LinearBody(body).lowest_frequency();
}

/// The same operators stepped: the mean, for the initial field is not quite the mode.
double period_of_run(CaseRun& run, int through) {
  const CaseScene swing = run.scene("swing", "plate.toml", {spacing(through)});
  return mean_period(swing.history.time, swing.probe("tip.displacement_y"));
}

}  // namespace

void beam_period(CaseRun& run) {
  constexpr const char* source = "plane elasticity, small amplitude";
  std::vector<CaseColumn> table = {{"particles", particles}};
  for (const Method& method : methods()) {
    std::vector<double>& errors = table.emplace_back(method.name).values;
    for (std::size_t k = 0; k < particles.size(); ++k) {
      const int through = particles.at(k);
      errors.push_back(period(run, method.settings, through) / exact_period - 1);
      const double within = method.within[k];
      run.check(source,
                fmt::format("error of the first period [%], {} particles through the thickness, {}",
                            through, method.name),
                100 * errors.back(), within > 0.0 ? absolute(0.0, within) : reported(0.0));
    }
  }
  run.check(source,
            "error of the first period [%], 10 particles, consistent (2, 1), three periods of "
            "a run",
            100 * (period_of_run(run, 10) / exact_period - 1), absolute(0.0, 0.2));
  run.table("periods", table);
}

}  // namespace tlsph

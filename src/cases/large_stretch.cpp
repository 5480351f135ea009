// A Neo-Hookean bar drawn to six times its length, and the stretch at which a nearly incompressible
// one stops to carry waves.
#include <fmt/format.h>

#include "list.hpp"
#include "stretched.hpp"
#include "tlsph/io/json.hpp"

namespace tlsph {
namespace {

constexpr double young = 200e9;
constexpr double length = 0.015;
constexpr std::array formulations = {"thesis", "mirror", "variational", "stress-point"};

/// The wide kernel of the collocated adjoint is not exact at the ends; nearest neighbours are.
constexpr const char* nearest = "kernel.support=1.5";

/// One run, with the stretch of the whole bar at the samples of its probes.
struct Drawn {
  CaseScene scene;
  std::vector<double> stretch;  ///< length over initial length
  std::vector<double> law;      ///< Cauchy stress of that stretch, (5.5) [Pa]
};

Drawn draw(CaseRun& run, const std::string& label, const std::string& formulation, double poisson,
           const Settings& settings = {}) {
  const Settings common = {"formulation=" + formulation,
                           fmt::format("material.poisson={}", poisson)};
  Drawn drawn{run.scene(label, "bar.toml", with(settings, common)), {}, {}};
  for (const double u : drawn.scene.probe("end.displacement_x")) {
    drawn.stretch.push_back(1 + u / length);
    drawn.law.push_back(neo_hookean_cauchy(lame(young, poisson), drawn.stretch.back(), 1.0));
  }
  return drawn;
}

Settings kernel_of(const std::string& formulation) {
  return formulation == "variational" ? Settings{nearest} : Settings{};
}

/// Of the Cauchy stress at both probes, up to a stretch of `to`; not a number if the run did not
/// come so far.
double stress_error(const Drawn& drawn, double to) {
  if (drawn.stretch.back() < to * (1 - 1e-9)) return std::nan("");
  return std::max(
      largest_deviation(drawn.stretch, drawn.scene.probe("middle.cauchy_xx"), drawn.law, to),
      largest_deviation(drawn.stretch, drawn.scene.probe("end.cauchy_xx"), drawn.law, to));
}

/// To a stretch of six, in stress and in the stretch of every material point.
void follow_curve(CaseRun& run, const std::string& formulation, double poisson) {
  const Drawn drawn = draw(run, fmt::format("{}-{}", formulation, poisson), formulation, poisson,
                           kernel_of(formulation));
  const auto local = drawn.scene.frame("deformation_gradient", 5);
  double uneven = local ? 0.0 : std::nan("");
  for (const double F : local.value_or(std::vector<double>{}))
    uneven = std::max(uneven, std::abs(F / 6 - 1));
  const std::string source = poisson == 0.3 ? "thesis, Fig. 5.5" : "thesis, sec. 5.3.2";
  const Claim claim = formulation == "thesis" ? reported() : at_most(1e-4);
  const Checks check(run, fmt::format(", nu = {}, {}", poisson, formulation));
  check(source, "relative error of the stress up to stretch 6", stress_error(drawn, 6), claim);
  check(source, "the same of the local stretch at 6", uneven, claim);
}

/// From rest, as fast as the source does it.
void follow_source(CaseRun& run, const std::string& formulation) {
  const Drawn drawn =
      draw(run, formulation + "-from-rest", formulation, 0.3,
           {"boundary[1].displacement.x.rise=77.57e-6", "time.end=77.57e-6",
            "initial={velocity=\"zero\"}", "output.probe_every=2", "output.frames=0"});
  run.check("thesis, Fig. 5.5",
            "relative error of the stress, from rest in 30 transits, " + formulation,
            stress_error(drawn, 6), reported());
}

/// Beyond the limit of hyperbolicity.
void lose_waves(CaseRun& run, const std::string& formulation) {
  constexpr double poisson = 0.49;
  const auto [lambda, mu] = lame(young, poisson);
  const double limit = first_loss([mu = mu, lambda = lambda](double F) {  // of dP/dF
    return mu * (1 + 1 / (F * F)) + lambda * (1 - std::log(F)) / (F * F);
  });
  const Drawn drawn = draw(run, fmt::format("{}-{}", formulation, poisson), formulation, poisson,
                           with(kernel_of(formulation), {"output.energy_every=10"}));
  // beyond the limit a run may end early; its summary is on disk all the same
  const Json summary = Json::read(drawn.scene.directory / "summary.json");
  double stretch = std::nan("");
  double mean = stretch;
  if (!summary.is_null("hyperbolicity_lost")) {
    stretch = summary.numbers("hyperbolicity_lost.stretches").front();
    mean = 1 + 5 * summary.number("hyperbolicity_lost.time") / 775.7e-6;
  }
  const bool thesis = formulation == "thesis";
  const Checks check(run, ", " + formulation);
  check("dP/dF = 0", "local stretch at the loss of hyperbolicity, nu = 0.49", stretch,
        relative(limit, 0.01));
  check("thesis, Fig. 5.6", "stretch of the bar then", mean,
        thesis ? reported(3.6) : relative(limit, 0.01));
  if (!thesis)
    check("thesis, Fig. 5.6", "relative error of the stress up to stretch 3.6, nu = 0.49",
          stress_error(drawn, 3.6), at_most(1e-4));
  const std::vector<double> local =
      drawn.scene.frame("deformation_gradient", 3).value_or(std::vector<double>{});
  const auto below = std::ranges::count_if(local, [&](double F) { return F < limit; });
  const auto above = std::ranges::count_if(local, [](double F) { return F > 6.4; });
  check("dP/dF < 0 between 3.63 and 6.40", "phases on both sides of that at stretch 4 (1: yes)",
        below > 0 && above > 0 ? 1.0 : 0.0, absolute(1.0, 0.0));
}

}  // namespace

void large_stretch(CaseRun& run) {
  for (const std::string formulation : formulations) {
    follow_curve(run, formulation, 0.3);
    follow_source(run, formulation);
    follow_curve(run, formulation, 0.48);
    lose_waves(run, formulation);
  }
  const Drawn wide = draw(run, "variational-wide", "variational", 0.3, {"output.frames=0"});
  run.check("", "relative error of the stress up to stretch 6, variational with support 2.5",
            stress_error(wide, 6), reported());
}

}  // namespace tlsph

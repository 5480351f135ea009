// Strain and stress waves in a strip six particles thick: their speed, and whether they are plane.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "list.hpp"
#include "samples.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

constexpr double young = 200e9;
constexpr double poisson = 0.3;
constexpr double density = 8000.0;

/// What comes back from the fixed end is cut off: only the pulse on its way there counts.
constexpr double before_reflection = 32e-6;  // [s]

/// Speed of the front between the probes at 0.05 and 0.10 m [m/s].
double front_speed(const CaseScene& scene) {
  const auto& time = scene.history.time;
  const auto samples =
      static_cast<std::size_t>(std::ranges::lower_bound(time, before_reflection) - time.begin());
  const auto at = [&](const char* column) {
    return arrival({std::span(time).first(samples), scene.probe(column).first(samples)});
  };
  return 0.05 / (at("p3.pk1_xx") - at("p2.pk1_xx"));
}

/// Transverse over axial stress at 0.05 m while the pulse is there.
double stress_ratio(const CaseScene& scene) {
  return peak(scene.samples("p2.pk1_yy"), before_reflection) /
         peak(scene.samples("p2.pk1_xx"), before_reflection);
}

/// The largest difference of u_x within a cross-section, in largest |u_x|, at the end.
double unevenness(const CaseScene& scene) {
  const std::vector<double> X = scene.data("particles/X");
  const std::vector<double> u = scene.frame("displacement", 1).value();
  struct Range {
    double least, most;
  };
  std::map<long, Range> sections;
  double largest = 0.0;
  for (std::size_t k = 0; k < X.size(); k += 2) {
    Range& range = sections.try_emplace(std::lround(X[k] * 1e6), Range{u[k], u[k]}).first->second;
    range = {std::min(range.least, u[k]), std::max(range.most, u[k])};
    largest = std::max(largest, std::abs(u[k]));
  }
  double widest = 0.0;
  for (const auto& [x, range] : sections) widest = std::max(widest, range.most - range.least);
  return widest / largest;
}

/// Nearest neighbours serve the collocated adjoint best: its sums are exact at the ends then.
Settings settings(const std::string& formulation) {
  const Settings result = {"formulation=" + formulation};
  return formulation == "variational" ? with(result, {"kernel.support=1.5"}) : result;
}

}  // namespace

void sheet_waves(CaseRun& run) {
  const double strain_speed = wave_speed(p_modulus(1, Assumption::strain, young, poisson), density);
  for (const std::string formulation : {"thesis", "mirror", "variational", "stress-point"}) {
    const CaseScene scene =
        run.scene("strain-" + formulation, "strain_wave.toml", settings(formulation));
    const Checks check(run, ", " + formulation);
    check("thesis, Fig. 5.7", "speed of the strain wave [m/s]", front_speed(scene),
          relative(strain_speed, 2e-3));
    check("thesis, Fig. 5.7", "P_yy/P_xx in the strain wave", stress_ratio(scene),
          relative(poisson / (1 - poisson), 1e-3));
    check("thesis, Fig. 5.7", "unevenness of u_x through the thickness", unevenness(scene),
          formulation == "thesis" ? reported()
                                  : at_most(formulation == "variational" ? 1e-4 : 1e-12));
  }
  for (const std::string formulation : {"variational", "stress-point"})
    for (const std::string assumption : {"strain", "stress"}) {
      const CaseScene scene =
          run.scene(fmt::format("plane-{}-{}", assumption, formulation), "stress_wave.toml",
                    with(settings(formulation), {"material.assumption=" + assumption}));
      const bool strain = assumption == "strain";
      const Checks check(run, fmt::format(" in plane {}, {}", assumption, formulation));
      const double modulus =
          p_modulus(2, Assumption::stress, young, poisson) * (strain ? 1 : 1 - poisson * poisson);
      check(strain ? "sqrt(E/(rho (1 - nu^2)))" : "thesis, Fig. 5.9",
            "speed of the stress wave [m/s]", front_speed(scene),
            relative(wave_speed(modulus, density), 5e-3));
      check("thesis, Fig. 5.9", "P_yy/P_xx in the stress wave", stress_ratio(scene), at_most(0.01));
      if (strain)
        run.check("thesis, Fig. 5.9",
                  "the same speed beside the one the thesis has, " + formulation + " [m/s]",
                  front_speed(scene), reported(wave_speed(young, density)));
    }
}

}  // namespace tlsph

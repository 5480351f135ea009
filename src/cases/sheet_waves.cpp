// Strain and stress waves in a strip six particles thick: their speed, and whether they are plane.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "list.hpp"
#include "signals.hpp"
#include "tlsph/io/hdf5.hpp"
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
  const auto& time = scene.probes.computed.time;
  const auto samples =
      static_cast<std::size_t>(std::ranges::lower_bound(time, before_reflection) - time.begin());
  const auto at = [&](const char* column) {
    return arrival(std::span(time).first(samples), scene.probe(column).first(samples));
  };
  return 0.05 / (at("p3.pk1_xx") - at("p2.pk1_xx"));
}

/// Transverse over axial stress at 0.05 m while the pulse is there.
double stress_ratio(const CaseScene& scene) {
  const auto& time = scene.probes.computed.time;
  return peak(time, scene.probe("p2.pk1_yy"), 0.0, before_reflection) /
         peak(time, scene.probe("p2.pk1_xx"), 0.0, before_reflection);
}

/// The largest difference of u_x within a cross-section, in largest |u_x|, at the end.
double unevenness(const CaseScene& scene) {
  const auto file = Hdf5File::open_read_only(scene.directory / "run.h5");
  const auto X = file.read_doubles("particles/X").values;
  const auto u = file.read_rows("frames/displacement", 1, 1).values;
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
std::vector<std::string> settings(const std::string& formulation) {
  std::vector<std::string> result = {"formulation=" + formulation};
  if (formulation == "variational") result.emplace_back("kernel.support=1.5");
  return result;
}

}  // namespace

void sheet_waves(CaseRun& run) {
  const double strain_speed = wave_speed(p_modulus(1, Assumption::strain, young, poisson), density);
  for (const std::string formulation : {"thesis", "mirror", "variational", "stress-point"}) {
    const CaseScene scene =
        run.scene("strain-" + formulation, "strain_wave.toml", settings(formulation));
    run.relative("thesis, Fig. 5.7", "speed of the strain wave, " + formulation + " [m/s]",
                 strain_speed, front_speed(scene), 2e-3);
    run.relative("thesis, Fig. 5.7", "P_yy/P_xx in the strain wave, " + formulation,
                 poisson / (1 - poisson), stress_ratio(scene), 1e-3);
    const std::string uneven = "unevenness of u_x through the thickness, " + formulation;
    if (formulation == "thesis")
      run.report("thesis, Fig. 5.7", uneven, unevenness(scene));
    else
      run.at_most("thesis, Fig. 5.7", uneven, formulation == "variational" ? 1e-4 : 1e-12,
                  unevenness(scene));
  }
  for (const std::string formulation : {"variational", "stress-point"})
    for (const std::string assumption : {"strain", "stress"}) {
      auto overrides = settings(formulation);
      overrides.push_back("material.assumption=" + assumption);
      const CaseScene scene = run.scene(fmt::format("plane-{}-{}", assumption, formulation),
                                        "stress_wave.toml", overrides);
      const bool strain = assumption == "strain";
      const double modulus =
          p_modulus(2, Assumption::stress, young, poisson) * (strain ? 1 : 1 - poisson * poisson);
      run.relative(
          strain ? "sqrt(E/(rho (1 - nu^2)))" : "thesis, Fig. 5.9",
          fmt::format("speed of the stress wave in plane {}, {} [m/s]", assumption, formulation),
          wave_speed(modulus, density), front_speed(scene), 5e-3);
      run.at_most(
          "thesis, Fig. 5.9",
          fmt::format("P_yy/P_xx in the stress wave in plane {}, {}", assumption, formulation),
          0.01, stress_ratio(scene));
      if (strain)
        run.report("thesis, Fig. 5.9",
                   "the same speed beside the one the thesis has, " + formulation + " [m/s]",
                   front_speed(scene), wave_speed(young, density));
    }
}

}  // namespace tlsph

// Wave speeds of three materials: the front of a pulse between two probes.
#include <fmt/format.h>

#include "list.hpp"
#include "samples.hpp"
#include "validation_bar.hpp"

namespace tlsph {
namespace {

/// Half of a front is late by what its kernel disperses.
double within(const std::string& formulation) {
  if (formulation == "stress-point") return 5e-4;
  return formulation == "mirror" ? 2e-3 : 3e-3;
}

struct Configuration {
  int number;      // of the thesis
  double density;  // [kg/m³]
  double young;    // [Pa]
};

}  // namespace

void three_materials(CaseRun& run) {
  using validation_bar::pressure;
  constexpr double middle_of_load = 3 * 0.5e-6 + validation_bar::duration / 2;
  for (const std::string formulation : validation_bar::formulations)
    for (const auto& [number, density, young] :
         {Configuration{1, 8000, 200e9}, {2, 8000, 100e9}, {3, 4000, 200e9}}) {
      const CaseScene wave =
          run.scene(fmt::format("{}-{}", formulation, number), "bar.toml",
                    {"formulation=" + formulation, fmt::format("material.young={}", young),
                     fmt::format("material.density={}", density)});
      const double speed =
          wave_speed(p_modulus(1, Assumption::strain, young, validation_bar::poisson), density);
      const double lapse = reaches(wave.samples("p3.pk1_xx"), 0.5 * pressure) -
                           reaches(wave.samples("p2.pk1_xx"), 0.5 * pressure);
      const Checks check(run, fmt::format(", configuration {}, {}", number, formulation));
      check("thesis, Fig. 4.14", "wave speed [m/s]", 0.05 / lapse,
            relative(speed, within(formulation)));
      if (number != 3) continue;
      const double back = middle_of_load + 0.35 / speed;
      check("thesis, Fig. 4.14", "tension at 0.05 m, back from the left end [Pa]",
            mean(wave.samples("p2.pk1_xx"), back - 2e-6, back + 2e-6),
            formulation == "thesis" ? reported(pressure) : relative(pressure, 2e-3));
    }
}

}  // namespace tlsph

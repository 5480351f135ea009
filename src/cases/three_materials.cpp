// Wave speeds of three materials: the front of a pulse between two probes.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "list.hpp"
#include "samples.hpp"
#include "validation_bar.hpp"

namespace tlsph {
namespace {

struct Configuration {
  int number;      // of the thesis
  double density;  // [kg/m³]
  double young;    // [Pa]

  [[nodiscard]] double speed() const {
    return wave_speed(p_modulus(1, Assumption::strain, young, validation_bar::poisson), density);
  }
};

/// Half of a front is late by what its kernel disperses.
double within(const std::string& formulation) {
  if (formulation == "stress-point") return 5e-4;
  return formulation == "mirror" ? 2e-3 : 3e-3;
}

}  // namespace

void three_materials(CaseRun& run) {
  constexpr std::array configurations = {
      Configuration{1, 8000, 200e9}, Configuration{2, 8000, 100e9}, Configuration{3, 4000, 200e9}};
  constexpr double half = 0.5 * validation_bar::pressure;
  constexpr double middle_of_load = 3 * 0.5e-6 + validation_bar::duration / 2;
  for (const std::string formulation : {"thesis", "mirror", "stress-point", "variational"})
    for (const Configuration& material : configurations) {
      const CaseScene wave =
          run.scene(fmt::format("{}-{}", formulation, material.number), "bar.toml",
                    {"formulation=" + formulation, fmt::format("material.young={}", material.young),
                     fmt::format("material.density={}", material.density)});
      const double lapse =
          reaches(wave.samples("p3.pk1_xx"), half) - reaches(wave.samples("p2.pk1_xx"), half);
      const std::string of = fmt::format(", configuration {}, {}", material.number, formulation);
      run.check("thesis, Fig. 4.14", "wave speed" + of + " [m/s]", 0.05 / lapse,
                relative(material.speed(), within(formulation)));
      if (material.number != 3) continue;
      const double back = middle_of_load + 0.35 / material.speed();
      constexpr double pressure = validation_bar::pressure;
      run.check("thesis, Fig. 4.14", "tension at 0.05 m, back from the left end" + of + " [Pa]",
                mean(wave.samples("p2.pk1_xx"), back - 2e-6, back + 2e-6),
                formulation == "thesis" ? reported(pressure) : relative(pressure, 2e-3));
    }
}

}  // namespace tlsph

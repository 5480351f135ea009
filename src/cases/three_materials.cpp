// Wave speeds of three materials: the front of a pulse between two probes.
#include <fmt/format.h>

#include <array>

#include "list.hpp"
#include "signals.hpp"

namespace tlsph {
namespace {

struct Material {
  double young;  // [Pa]
  double speed;  // of the longitudinal wave in 1D strain [m/s]
};

}  // namespace

void three_materials(CaseRun& run) {
  constexpr std::array materials = {Material{200e9, 5801.2}, Material{100e9, 4102.1},
                                    Material{400e9, 8204.2}};
  for (const char* formulation : {"stress-point", "mirror", "thesis"})
    for (const Material& material : materials) {
      const CaseScene scene =
          run.scene(fmt::format("{}-{:.0f}", formulation, material.young / 1e9), "bar.toml",
                    {fmt::format("formulation={}", formulation),
                     fmt::format("material.young={}", material.young)});
      const auto& time = scene.history.time;
      const double lapse =
          arrival(time, scene.probe("p3.pk1_xx")) - arrival(time, scene.probe("p2.pk1_xx"));
      run.relative(
          "thesis, Fig. 4.14",
          fmt::format("wave speed, E = {:.0f} GPa, {} [m/s]", material.young / 1e9, formulation),
          material.speed, 0.05 / lapse, 5e-3);
    }
}

}  // namespace tlsph

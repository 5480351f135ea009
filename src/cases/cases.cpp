#include "tlsph/cases/cases.hpp"

#include <array>

#include "list.hpp"

namespace tlsph {

std::span<const Case> all_cases() {
  // name (the folder), title, seconds on one core, quick, function
  static constexpr std::array list = {
      Case{"large_stretch", "a bar stretched sixfold; loss of hyperbolicity", 4.0, true,
           large_stretch},
      Case{"sheet_stretch", "a sheet stretched in two directions; loss of hyperbolicity", 5.0, true,
           sheet_stretch},
      Case{"sheet_waves", "strain and stress waves in a strip", 1.0, true, sheet_waves},
      Case{"sheet_with_hole", "a sheet with a hole: where its peak stress converges", 70.0, false,
           sheet_with_hole},
      Case{"bar_pulse", "a pressure pulse in a bar, by d'Alembert", 2.0, true, bar_pulse},
      Case{"impedance", "a pulse at a change of density", 4.0, true, impedance},
      Case{"neo_hookean_wave", "a large wave, by characteristics", 3.0, true, neo_hookean_wave},
      Case{"step_limit", "time steps around the stability limit", 5.0, true, step_limit},
      Case{"interpolation", "SPH sums of known functions", 1.0, true, interpolation},
      Case{"three_materials", "wave speeds of three materials", 2.0, true, three_materials},
      Case{"mixed_kernels", "kernels of strain and stress that differ, and the mixed form", 11.0,
           false, mixed_kernels},
      Case{"corrections", "corrected gradients, and which pairs keep momentum", 3.0, true,
           corrections},
      Case{"dispersion", "waves on a lattice and modes without energy", 1.0, true, dispersion},
      Case{"swinging_plate", "a plate that swings without changing its volume", 3.0, true,
           swinging_plate},
      Case{"consistency", "irregular particles, with and without an exact adjoint", 130.0, false,
           consistency},
      Case{"kirsch", "a plate with a hole at rest, by Kirsch's solution", 50.0, false, kirsch},
      Case{"beam_period", "the first period of a clamped plate", 20.0, false, beam_period},
      Case{"satellite", "a free body spins", 30.0, false, satellite},
      Case{"tensile_instability", "a prestressed bar, one particle displaced", 1.0, true,
           tensile_instability},
      Case{"swegle", "a prestressed sheet, one particle pushed", 25.0, false, swegle},
      Case{"block_impact", "two bonded blocks that meet", 1.0, true, block_impact},
  };
  return list;
}

}  // namespace tlsph

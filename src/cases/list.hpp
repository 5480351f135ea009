#pragma once
/// \file
/// The cases, a function each, in the order of the table: the name of its folder and function, a
/// title, about how many seconds it takes on one core, whether it is part of --quick.

#include "checks.hpp"

#define TLSPH_CASES(CASE)                                                                          \
  CASE(large_stretch, "a bar stretched sixfold; loss of hyperbolicity", 4.0, true)                 \
  CASE(sheet_stretch, "a sheet stretched in two directions; loss of hyperbolicity", 5.0, true)     \
  CASE(sheet_waves, "strain and stress waves in a strip", 1.0, true)                               \
  CASE(sheet_with_hole, "a sheet with a hole: where its peak stress converges", 70.0, false)       \
  CASE(bar_pulse, "a pressure pulse in a bar, by d'Alembert", 2.0, true)                           \
  CASE(impedance, "a pulse at a change of density", 4.0, true)                                     \
  CASE(neo_hookean_wave, "a large wave, by characteristics", 3.0, true)                            \
  CASE(step_limit, "time steps around the stability limit", 5.0, true)                             \
  CASE(interpolation, "SPH sums of known functions", 1.0, true)                                    \
  CASE(three_materials, "wave speeds of three materials", 2.0, true)                               \
  CASE(mixed_kernels, "kernels of strain and stress that differ, and the mixed form", 11.0, false) \
  CASE(corrections, "corrected gradients, and which pairs keep momentum", 3.0, true)               \
  CASE(dispersion, "waves on a lattice and modes without energy", 1.0, true)                       \
  CASE(swinging_plate, "a plate that swings without changing its volume", 3.0, true)               \
  CASE(consistency, "irregular particles, with and without an exact adjoint", 130.0, false)        \
  CASE(kirsch, "a plate with a hole at rest, by Kirsch's solution", 50.0, false)                   \
  CASE(beam_period, "the first period of a clamped plate", 20.0, false)                            \
  CASE(satellite, "a free body spins", 30.0, false)                                                \
  CASE(tensile_instability, "a prestressed bar, one particle displaced", 1.0, true)                \
  CASE(swegle, "a prestressed sheet, one particle pushed", 25.0, false)                            \
  CASE(block_impact, "two bonded blocks that meet", 1.0, true)

namespace tlsph {

#define TLSPH_DECLARE(name, title, seconds, quick) void name(CaseRun& run);
TLSPH_CASES(TLSPH_DECLARE)
#undef TLSPH_DECLARE

}  // namespace tlsph

#pragma once
/// \file
/// The cases, a function each.

#include "tlsph/studies/validation.hpp"

namespace tlsph {

void large_stretch(CaseRun& run);
void sheet_stretch(CaseRun& run);
void sheet_waves(CaseRun& run);
void sheet_with_hole(CaseRun& run);
void bar_pulse(CaseRun& run);
void impedance(CaseRun& run);
void neo_hookean_wave(CaseRun& run);
void step_limit(CaseRun& run);
void three_materials(CaseRun& run);
void corrections(CaseRun& run);
void mixed_kernels(CaseRun& run);
void interpolation(CaseRun& run);
void dispersion(CaseRun& run);
void swinging_plate(CaseRun& run);
void consistency(CaseRun& run);
void kirsch(CaseRun& run);
void beam_period(CaseRun& run);
void satellite(CaseRun& run);
void tensile_instability(CaseRun& run);
void swegle(CaseRun& run);
void block_impact(CaseRun& run);

}  // namespace tlsph

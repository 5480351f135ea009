#pragma once
/// \file
/// What the runs of a row showed, as a sentence; and the regions that are no verdict on a state.

#include <string>
#include <vector>

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// The run of that label, nullptr if there is none.
[[nodiscard]] const PerturbedRun* run_of(const AtlasRow& row, const std::string& label);

/// Stable, and its run at 0.95 of the critical step stays bounded.
[[nodiscard]] bool holds(const AtlasRow& row);

/// The run of a row that holds; the run of one that does not.
[[nodiscard]] std::string stays(const AtlasRow& row);
[[nodiscard]] std::string grows(const AtlasRow& row, const PerturbedRun& run);

/// Steps beyond the limit, by a little and by the rule h/c.
void add_long_steps(const Atlas& atlas, std::vector<Failure>& failures);
/// Uniform stress that the operators do not balance.
void add_imbalance(const Atlas& atlas, std::vector<Failure>& failures);
/// Kernel sums that follow the particles.
void add_contrast(const Atlas& atlas, std::vector<Failure>& failures);
/// Compression faster than the step follows.
void add_crush(const Atlas& atlas, std::vector<Failure>& failures);

}  // namespace tlsph

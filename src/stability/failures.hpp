#pragma once
/// \file
/// The failures of an atlas as text. States that fail in the same way are one entry: it shows the
/// state that fails most plainly and one that differs in the cure and does not fail.

#include <string>
#include <vector>

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// Of the chosen rows the one with the largest key, the first of equals; nullptr if there is none.
template <class Row, class Chosen, class Key>
const Row* largest(const std::vector<Row>& rows, const Chosen& chosen, const Key& key) {
  const Row* best = nullptr;
  for (const Row& row : rows)
    if (chosen(row) && (best == nullptr || key(row) > key(*best))) best = &row;
  return best;
}

/// Stable, and its run at 0.95 of the critical step stays bounded.
[[nodiscard]] bool confirmed_stable(const AtlasRow& row);
/// What the run of such a row showed, and the run of one that grows.
[[nodiscard]] std::string bounded_text(const AtlasRow& row);
[[nodiscard]] std::string growth_text(const AtlasRow& row, const PerturbedRun& run);

/// Body, jitter, Poisson ratio and stretch are the same.
[[nodiscard]] bool same_state(const AtlasRow& a, const AtlasRow& b);

/// Failures that are not read off the verdicts: steps beyond the limit, uniform stress that is not
/// balanced, the updated-Lagrangian example, compression at a step that is not adapted.
void add_failures_of_runs(const Atlas& atlas, std::vector<Failure>& failures);

}  // namespace tlsph

#pragma once
/// \file
/// The failures of an atlas in words. Rows that fail in the same way are one region; it shows the
/// row that fails most plainly and, beside it, one that differs in the cure and does not fail.

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

[[nodiscard]] std::vector<Failure> failures_of(const Atlas& atlas);

}  // namespace tlsph

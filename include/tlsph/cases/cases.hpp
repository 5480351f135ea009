#pragma once
/// \file
/// The problems of the literature this project stands on, one file a case in src/cases; scenes,
/// reference data, figure and a few words on each are in validation/<case>.

#include <span>

#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// Every case, in the order of the table.
[[nodiscard]] std::span<const Case> all_cases();

}  // namespace tlsph

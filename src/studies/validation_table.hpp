#pragma once
/// \file
/// The result of a case as JSON: how its process hands it over, and an entry of validation.json.

#include "tlsph/io/table.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

[[nodiscard]] Table<CaseResult> case_table();
/// A result from its row. InputError if the document is no such thing.
[[nodiscard]] CaseResult read_checks(const Json& json);

}  // namespace tlsph

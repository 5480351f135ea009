#pragma once
/// \file
/// A case's result as JSON: how its process hands it over, and an entry of validation.json.

#include "tlsph/io/json.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

[[nodiscard]] Json checks_json(const CaseResult& result);
/// The result again. InputError if the document is no such thing.
[[nodiscard]] CaseResult read_checks(const Json& json);

}  // namespace tlsph

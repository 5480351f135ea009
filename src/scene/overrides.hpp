#pragma once
/// \file
/// Changes to a scene's tree by dotted path: `--set key=value`.

#include <string>

#include "document.hpp"

namespace tlsph {

/// Sets the value at `key` of `key=value` in the tree; tables and one more list entry are created
/// on the way as needed. InputError, naming the override, if it is malformed or the path runs
/// through something that has no keys.
void apply_override(Node& root, const std::string& override_text);

}  // namespace tlsph

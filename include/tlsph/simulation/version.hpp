#pragma once
/// \file
/// The version of the program, as its build knows it.

#include <string>

namespace tlsph {

/// "0.1.0"
[[nodiscard]] std::string version();

}  // namespace tlsph

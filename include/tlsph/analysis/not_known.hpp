#pragma once
/// \file
/// What stands where there is no number.

#include <limits>

namespace tlsph {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace tlsph

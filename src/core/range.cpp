#include "tlsph/core/range.hpp"

#include <fmt/format.h>

namespace tlsph {

std::string Range::text() const {
  if (high == std::numeric_limits<double>::infinity())
    return fmt::format("{} {:g}", with_low ? ">=" : ">", low);
  return fmt::format("{}{:g}, {:g}{}", with_low ? '[' : '(', low, high, with_high ? ']' : ')');
}

std::string Range::requirement() const {
  return high == std::numeric_limits<double>::infinity() ? text() : "in " + text();
}

}  // namespace tlsph

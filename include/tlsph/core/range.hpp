#pragma once
/// \file
/// The values a number may take.

#include <limits>
#include <string>

namespace tlsph {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool with_low = false, with_high = false;  ///< whether the ends belong to it

  [[nodiscard]] constexpr bool contains(double x) const {
    return (with_low ? x >= low : x > low) && (with_high ? x <= high : x < high);
  }
  /// `> 0`, `>= 0` or `(-1, 0.5]`.
  [[nodiscard]] std::string text() const;
  /// What a number must be: the text, with "in " before an interval.
  [[nodiscard]] std::string requirement() const;
};

[[nodiscard]] constexpr Range above(double low) {
  return {low};
}
[[nodiscard]] constexpr Range not_below(double low) {
  return {.low = low, .with_low = true};
}
/// Without its ends.
[[nodiscard]] constexpr Range between(double low, double high) {
  return {low, high};
}
/// With its ends.
[[nodiscard]] constexpr Range closed(double low, double high) {
  return {low, high, true, true};
}

}  // namespace tlsph

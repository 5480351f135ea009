#pragma once
/// \file
/// What is read off a history.

#include <span>

namespace tlsph {

/// When the size of `values` first reaches `level`, between two samples linearly [s]; the last
/// instant if it never does.
[[nodiscard]] double reaches(std::span<const double> time, std::span<const double> values,
                             double level);

/// When the size of `values` first reaches `share` of its largest [s].
[[nodiscard]] double arrival(std::span<const double> time, std::span<const double> values,
                             double share = 0.5);

/// The largest size of `values` in the window [from, to] of time.
[[nodiscard]] double peak(std::span<const double> time, std::span<const double> values, double from,
                          double to);

/// The mean of `values` over the window [from, to] of time, by the trapezoidal rule between the
/// samples inside it.
[[nodiscard]] double mean(std::span<const double> time, std::span<const double> values, double from,
                          double to);

/// The largest |values − exact|.
[[nodiscard]] double largest_difference(std::span<const double> values,
                                        std::span<const double> exact);

/// √(∫ (values − exact)² dt / ∫ exact² dt) by the trapezoidal rule.
[[nodiscard]] double relative_error(std::span<const double> time, std::span<const double> values,
                                    std::span<const double> exact);

}  // namespace tlsph

#pragma once
/// \file
/// What is read off a history.

#include <span>

namespace tlsph {

/// When the size of `values` first reaches `share` of its largest, between two samples linearly
/// [s].
[[nodiscard]] double arrival(std::span<const double> time, std::span<const double> values,
                             double share = 0.5);

/// The largest size of `values` in the window [from, to] of time.
[[nodiscard]] double peak(std::span<const double> time, std::span<const double> values, double from,
                          double to);

}  // namespace tlsph

#pragma once
/// \file
/// How far two histories are apart. Two runs step differently, so one is brought to the times of
/// the other.

#include <span>
#include <vector>

namespace tlsph {

/// Values at the instants `at` by the cubic through the four nearest samples (third-order, steps
/// may vary; a line or a parabola where there are only two or three samples). Instants outside the
/// samples take the first or last value. At least one sample.
[[nodiscard]] std::vector<double> resample(std::span<const double> time,
                                           std::span<const double> values,
                                           std::span<const double> at);

/// ∫ q² dt by the trapezoidal rule.
[[nodiscard]] double squared_norm(std::span<const double> time, std::span<const double> values);

}  // namespace tlsph

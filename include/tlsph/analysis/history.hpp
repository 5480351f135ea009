#pragma once
/// \file
/// Numbers read off a history: how far it goes, how long it takes to come back, how fast it grows,
/// how far it is from another. Two runs step differently, so one is brought to the times of the
/// other.

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

/// The largest value, between the samples by the parabola through the largest of them and its
/// neighbours, so that it converges with the samples as the history does. At least one sample,
/// times increasing.
[[nodiscard]] double maximum(std::span<const double> time, std::span<const double> values);
/// The smallest value, likewise.
[[nodiscard]] double minimum(std::span<const double> time, std::span<const double> values);

/// Times at which the values pass `level`, on the line between two samples [s]; starting on it is
/// no passage.
[[nodiscard]] std::vector<double> passages(std::span<const double> time,
                                           std::span<const double> values, double level = 0.0);

/// Period of an oscillation about `level` [s]: twice the slope of the straight line through the
/// passages against their number. Successive half periods differ by the other modes that are
/// excited, their mean does not. Not a number with fewer than three passages, or where two of them
/// lie further apart than 1.5 or nearer than 0.5 of the mean: that is no single oscillation.
[[nodiscard]] double mean_period(std::span<const double> time, std::span<const double> values,
                                 double level = 0.0);

/// Rate of exponential growth [1/s]: slope of ln(values) by least squares over the samples from the
/// first that reaches `low` to the last before `high`. Not a number where the values do not grow
/// that far.
[[nodiscard]] double growth_rate(std::span<const double> time, std::span<const double> values,
                                 double low, double high);

}  // namespace tlsph

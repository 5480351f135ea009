#pragma once
/// \file
/// Numbers read off a history: how far it goes, how long it takes to come back.

#include <span>
#include <vector>

namespace tlsph {

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

}  // namespace tlsph

#pragma once
/// \file
/// What is read off the samples of a probe.

#include <limits>

#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// When the size of the values first reaches `level`, between two samples linearly [s]; the last
/// instant if it never does.
[[nodiscard]] double reaches(const Samples& samples, double level);

/// When the size of the values first reaches `share` of its largest [s].
[[nodiscard]] double arrival(const Samples& samples, double share = 0.5);

/// The largest size of the values until `end` [s].
[[nodiscard]] double peak(const Samples& samples,
                          double end = std::numeric_limits<double>::infinity());

/// The mean of the values over the window [from, to] of time, by the trapezoidal rule between the
/// samples inside it.
[[nodiscard]] double mean(const Samples& samples, double from, double to);

/// The largest |values − exact|.
[[nodiscard]] double largest_difference(std::span<const double> values,
                                        std::span<const double> exact);

/// √(∫ (values − exact)² dt / ∫ exact² dt) by the trapezoidal rule.
[[nodiscard]] double relative_error(const Samples& samples, std::span<const double> exact);

/// The same of a column of the probes against the exact solution of the scene.
[[nodiscard]] double relative_error(const CaseScene& scene, std::string_view column);

}  // namespace tlsph

#pragma once
/// \file
/// Histories: columns of numbers over time, as probes.csv holds them, and how far two of them are
/// apart. Two runs step differently, so one is brought to the times of the other.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tlsph {

struct History {
  std::vector<double> time;  ///< [s], increasing
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;  ///< by name, one an instant
};

/// Reads a table whose first column is `time`, all others numbers. InputError, naming file and
/// line, for what is no such table.
[[nodiscard]] History read_history(const std::filesystem::path& csv);

/// Values at the instants `at` by the cubic through the four nearest samples (third-order, steps
/// may vary; a line or a parabola where there are only two or three samples). Instants outside the
/// samples take the first or last value. At least one sample.
[[nodiscard]] std::vector<double> resample(std::span<const double> time,
                                           std::span<const double> values,
                                           std::span<const double> at);

/// ∫ q² dt by the trapezoidal rule.
[[nodiscard]] double squared_norm(std::span<const double> time, std::span<const double> values);

}  // namespace tlsph

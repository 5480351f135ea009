#pragma once
/// \file
/// The three ways a run can fail. Input errors are thrown before the first step and name place and
/// remedy; numerical errors name time and particle; output errors name the file.

#include <stdexcept>
#include <string>

namespace tlsph {

/// Where in the user's input something is wrong; empty or zero fields are left out of the message.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
  std::string key;

  /// `file:line:col: key: ` with the parts that are known.
  [[nodiscard]] std::string prefix() const {
    std::string text = file;
    if (line > 0) text += ':' + std::to_string(line) + ':' + std::to_string(column);
    if (!text.empty()) text += ": ";
    if (!key.empty()) text += key + ": ";
    return text;
  }
};

/// The user asked for something impossible (exit code 2). The message says what is wrong and what
/// is allowed.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const Place& place, const std::string& message)
      : std::runtime_error(place.prefix() + message) {}
};

/// The run lost its physics (exit code 3): det F ≤ 0 or a value that is not finite.
class NumericalError : public std::runtime_error {
 public:
  NumericalError(const std::string& message, double time, long particle)
      : std::runtime_error(message), time_(time), particle_(particle) {}
  /// Simulated time [s] of the failure.
  [[nodiscard]] double time() const { return time_; }
  /// Index of the material point (or node) that failed, −1 if it is none in particular.
  [[nodiscard]] long particle() const { return particle_; }

 private:
  double time_;
  long particle_;
};

/// A result could not be written (exit code 4).
class OutputError : public std::runtime_error {
 public:
  explicit OutputError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace tlsph

#pragma once
/// \file
/// Another program, run to its end.

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tlsph {

struct ProcessOptions {
  std::filesystem::path out = "/dev/null", err = "/dev/null";  ///< where its streams go
  std::optional<double> seconds;                      ///< killed after so many, with its children
  const std::atomic<bool>* stop_requested = nullptr;  ///< likewise
};

/// Exit code of the program, which reads nothing; empty if it could not be started, was killed or
/// ended by a signal.
[[nodiscard]] std::optional<int> run_process(std::vector<std::string> words,
                                             const ProcessOptions& options = {});

/// The system's Python, whose packages Debian installs, else the first on the path.
[[nodiscard]] std::string python();

}  // namespace tlsph

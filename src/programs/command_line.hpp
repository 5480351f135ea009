#pragma once
/// \file
/// What the user typed, as plain data: the only door to the command-line library.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tlsph {

enum class Command {
  run,
  plan,
  export_operators,
  converge,
  chart,
  fit,
  stability,
  validate,
  benchmark,
  scene_reference
};

struct CommandLine {
  Command command = Command::run;
  std::filesystem::path scene;
  std::vector<std::string> overrides;  // key=value, in order
  std::filesystem::path out;           // empty: the default of the command
  int threads = 0;                     // 0: as many as pay
  bool quiet = false;
  bool resume = false;
  std::vector<double> spacings;           // converge, chart
  std::vector<std::string> formulations;  // converge; empty: the scene's
  std::vector<std::string> over;          // converge, key=a,b,c
  std::vector<std::uint64_t> seeds;       // converge
  std::vector<std::string> clouds;        // converge
  std::vector<std::string> values;        // converge, chart, fit (one)
  std::vector<std::string> peers;         // chart
  double budget = 120.0;                  // chart [s]
  std::vector<std::string> cases;         // validate; empty: all
  bool quick = false;                     // validate
  double particles = 0.0;                 // benchmark; 0: the usual number
  double seconds = 0.0;                   // benchmark; 0: the usual batch
  std::string only;                       // stability; empty: all
  double error = 0.0;                     // fit
  std::string quantity;                   // fit; empty: the worst
};

/// Reads the arguments. Empty if all the user wanted was help or the version, which is printed
/// then. InputError for anything else that is no command.
[[nodiscard]] std::optional<CommandLine> parse_command_line(int argc, const char* const* argv);

}  // namespace tlsph

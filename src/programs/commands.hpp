#pragma once
/// \file
/// The commands of the program: what the user typed as plain data, what runs it, and what the shell
/// is told.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tlsph {

enum class ExitCode {
  done = 0,
  verdict_failed = 1,  // a validation case, or a fit that found nothing
  bad_input = 2,       // scene, overrides, command line, not enough memory
  numerical_failure = 3,
  no_output = 4,        // a result could not be written
  internal_error = 70,  // a defect of the program itself
  interrupted = 130,    // 128 + SIGINT
  terminated = 143,     // 128 + SIGTERM
};

struct CommandLine {
  ExitCode (*command)(const CommandLine&) = nullptr;
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

/// Reads the arguments: the only door to the command-line library. Empty if all the user wanted was
/// help or the version, which is printed then. InputError for anything else that is no command.
[[nodiscard]] std::optional<CommandLine> parse_command_line(int argc, const char* const* argv);

// The commands. InputError, NumericalError or OutputError if they fail.
ExitCode run_scene(const CommandLine& line);
ExitCode plan_scene(const CommandLine& line);
ExitCode export_scene(const CommandLine& line);
ExitCode converge_scene(const CommandLine& line);
ExitCode draw_stability(const CommandLine& line);
ExitCode chart_scene(const CommandLine& line);
ExitCode fit_scene(const CommandLine& line);
ExitCode validate_cases(const CommandLine& line);
ExitCode benchmark_steps(const CommandLine& line);
ExitCode print_reference(const CommandLine& line);

/// Exit code of a command that a signal stopped: 128 + the signal's number.
[[nodiscard]] ExitCode interruption();

}  // namespace tlsph

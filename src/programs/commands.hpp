#pragma once
/// \file
/// What each command does once the command line is understood.

#include "command_line.hpp"
#include "exit_code.hpp"

namespace tlsph {

/// Runs the command. Errors come out as InputError, NumericalError or OutputError.
[[nodiscard]] ExitCode execute(const CommandLine& line);

/// Of a command that a signal stopped.
[[nodiscard]] ExitCode interruption();

}  // namespace tlsph

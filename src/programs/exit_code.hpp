#pragma once
/// \file
/// What the program tells the shell.

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

}  // namespace tlsph

// tlsph: one command a study. Errors become exit codes here and nowhere else.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include "commands.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"

namespace {

using tlsph::ExitCode;

/// An error that cannot be told (a full disk, a closed stream) has its exit code all the same.
ExitCode complain(const std::string& message, ExitCode code) {
  (void)std::fputs((message + "\n").c_str(), stderr);
  return code;
}

/// Streams the caller has closed are opened such that using them fails: the next file that is
/// opened would take their place, and messages would go into it.
void guard_streams() {
  for (const int stream : {0, 1, 2})
    if (fcntl(stream, F_GETFD) < 0) (void)open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
}

/// A reader that went away and a limit on the size of files (ulimit -f) are failures to write, told
/// like all others.
void keep_write_errors() {
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
}

// A signal handler can reach nothing but static storage.
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  const bool insists = tlsph::may_end_at_once() || tlsph::stop_flag().exchange(true);
  if (insists) _exit(128 + number);
  received = number;
}

/// Ctrl-C and `kill`. As long as nothing is written either ends the program at once; then it is a
/// request (core/stop.hpp): a run finishes its step and saves, a study ends the piece it is at. A
/// second signal ends the program at once.
void end_on_interrupts() {
  (void)tlsph::stop_flag();  // made here, not in the handler
  tlsph::may_end_at_once() = true;
  // A signal that the parent ignores (nohup, a background job of a script) stays ignored.
  for (const int number : {SIGINT, SIGTERM})
    if (std::signal(number, on_signal) == SIG_IGN) std::signal(number, SIG_IGN);
}

ExitCode run_program(int argc, const char* const* argv) {
  try {
    const auto line = tlsph::parse_command_line(argc, argv);
    return line ? line->command(*line) : ExitCode::done;
  } catch (const tlsph::Stopped&) {
    return tlsph::interruption();
  } catch (const tlsph::InputError& error) {
    return complain(error.what(), ExitCode::bad_input);
  } catch (const tlsph::NumericalError& error) {
    return complain(error.what(), ExitCode::numerical_failure);
  } catch (const tlsph::OutputError& error) {
    return complain(error.what(), ExitCode::no_output);
  } catch (const std::filesystem::filesystem_error& error) {
    return complain(error.what(), ExitCode::no_output);
  } catch (const std::bad_alloc&) {
    return complain("out of memory; choose a larger body.spacing", ExitCode::bad_input);
  } catch (const std::exception& error) {
    return complain(fmt::format("internal error: {}", error.what()), ExitCode::internal_error);
  }
}

}  // namespace

ExitCode tlsph::interruption() {
  return received == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
}

int main(int argc, char** argv) {
  guard_streams();
  keep_write_errors();
  end_on_interrupts();
  return static_cast<int>(run_program(argc, argv));
}

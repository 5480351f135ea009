#pragma once
/// \file
/// Ctrl-C and `kill`. As long as nothing is written either ends the program at once; then it is a
/// request (core/stop.hpp): a run finishes its step and saves, a study ends the piece it is at. A
/// second signal ends the program at once. The exit code is 128 + the signal's number.

#include <atomic>

namespace tlsph {

/// From now on SIGINT and SIGTERM end the program, at once until `may_end_at_once` is taken back.
void end_on_interrupts();

/// Takes that back; the first signal sets the flag this returns.
[[nodiscard]] const std::atomic<bool>* catch_interrupts();

/// The signal that came, 0 if none did.
[[nodiscard]] int interrupt_received();

}  // namespace tlsph

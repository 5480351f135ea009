#pragma once
/// \file
/// Ctrl-C and `kill` as a request: the run finishes its step and saves. A second signal ends the
/// program at once.

#include <atomic>

namespace tlsph {

/// From now on SIGINT and SIGTERM set the flag this returns.
[[nodiscard]] const std::atomic<bool>* catch_interrupts();

/// The signal that came, 0 if none did.
[[nodiscard]] int interrupt_received();

}  // namespace tlsph

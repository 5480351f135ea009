#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>

#include "tlsph/core/stop.hpp"

namespace tlsph {
namespace {

// A signal handler can reach nothing but static storage.
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  if (may_end_at_once() || stop_flag().exchange(true)) _exit(128 + number);  // or the user insists
  received = number;
}

}  // namespace

void end_on_interrupts() {
  (void)stop_flag();  // made here, not in the handler
  may_end_at_once() = true;
  // A signal that the parent ignores (nohup, a background job of a script) stays ignored.
  for (const int number : {SIGINT, SIGTERM})
    if (std::signal(number, on_signal) == SIG_IGN) std::signal(number, SIG_IGN);
}

const std::atomic<bool>* catch_interrupts() {
  may_end_at_once() = false;
  return &stop_flag();
}

int interrupt_received() {
  return received;
}

}  // namespace tlsph

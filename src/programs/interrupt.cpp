#include "interrupt.hpp"

#include <csignal>

namespace tlsph {
namespace {

// A signal handler can reach nothing but static storage; this is the one place that has any.
std::atomic<bool> requested{false};
std::atomic<int> received{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  if (requested.exchange(true)) {  // the user insists
    std::signal(number, SIG_DFL);
    std::raise(number);
    return;
  }
  received = number;
}

}  // namespace

const std::atomic<bool>* catch_interrupts() {
  // A signal that the parent ignores (nohup, a background job of a script) stays ignored.
  for (const int number : {SIGINT, SIGTERM})
    if (std::signal(number, on_signal) == SIG_IGN) std::signal(number, SIG_IGN);
  return &requested;
}

int interrupt_received() {
  return received;
}

}  // namespace tlsph

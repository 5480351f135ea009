#pragma once
/// \file
/// A request to stop, between the pieces of long work. A signal handler reaches nothing but static
/// storage, so the request is one for the whole program.

#include <atomic>

namespace tlsph {

/// What a stop point throws; no std::exception, so that nobody takes it for a failure.
struct Stopped {};

/// Whether the program is asked to stop; a signal handler sets it.
[[nodiscard]] inline std::atomic<bool>& stop_flag() {
  static std::atomic<bool> requested{false};
  static_assert(std::atomic<bool>::is_always_lock_free);
  return requested;
}

/// Whether a signal may end the program at once, for nothing is written yet. Who touches the first
/// file of a result takes this back.
[[nodiscard]] inline std::atomic<bool>& may_end_at_once() {
  static std::atomic<bool> allowed{false};
  return allowed;
}

/// Between two pieces of work that has nothing to save: throws Stopped when a stop was requested.
inline void stop_point() {
  if (stop_flag()) throw Stopped{};
}

}  // namespace tlsph

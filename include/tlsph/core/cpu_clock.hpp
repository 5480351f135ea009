#pragma once
/// \file
/// What this thread has worked: time in which other programs have its core does not count.

#include <ctime>

namespace tlsph {

/// CPU time of this thread since it began [s].
[[nodiscard]] inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace tlsph

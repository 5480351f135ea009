#pragma once
/// \file
/// The memory of this process as the system counts it.

#include <fstream>
#include <string>

namespace tlsph {

/// A number of /proc/self/status [bytes], 0 where there is none: "VmHWM:", the most that was
/// resident, or "VmRSS:", what is. (getrusage speaks of the process that started this one too.)
inline double memory_status(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0.0; word == name && status >> kilobytes) return 1024.0 * kilobytes;
  return 0.0;
}

/// From now on the most that was resident is counted anew, where the system lets us.
inline void forget_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace tlsph

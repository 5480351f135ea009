#pragma once
/// \file
/// Wall time.

#include <chrono>

namespace tlsph {

class Stopwatch {
 public:
  /// Seconds on a steady clock.
  [[nodiscard]] static double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
  [[nodiscard]] double seconds() const { return now() - start_; }

 private:
  double start_ = now();
};

}  // namespace tlsph

#pragma once
/// \file
/// Time steps that land on the end: a segment of equal steps, replaced when the critical step
/// changes.

#include <cmath>

namespace tlsph {

struct Clock {
  double start = 0.0;  ///< of the segment [s]
  long first = 0;      ///< step at which it starts
  long count = 1;      ///< steps in it
  double end = 0.0;    ///< of the run [s]
  double dt = 0.0;     ///< [s]

  /// Steps of at most `limit` from (time, step) to `end`.
  static Clock from(double time, long step, double end, double limit) {
    Clock clock;
    clock.start = time;
    clock.first = step;
    clock.end = end;
    clock.count = std::max(1L, static_cast<long>(std::ceil((end - time) / limit * (1.0 - 1e-12))));
    clock.dt = (end - time) / static_cast<double>(clock.count);
    return clock;
  }
  [[nodiscard]] long last() const { return first + count; }
  [[nodiscard]] double time(long step) const {
    return step == last() ? end : start + static_cast<double>(step - first) * dt;
  }
};

}  // namespace tlsph

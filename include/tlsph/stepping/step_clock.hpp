#pragma once
/// \file
/// Time steps that land on the end: a segment of equal steps, replaced when the critical step
/// changes.

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tlsph {

struct StepClock {
  double start = 0.0;  ///< of the segment [s]
  long first = 0;      ///< step at which it starts
  long count = 1;      ///< steps in it
  double end = 0.0;    ///< of the run [s], perhaps infinite
  double dt = 0.0;     ///< [s]

  /// Beyond it steps that are counted in double precision are no integers any more.
  static constexpr double most_count = 9e15;

  /// Steps of at most `limit` from (time, step) to `end`. std::invalid_argument if they are more.
  static StepClock from(double time, long step, double end, double limit) {
    StepClock clock;
    clock.start = time;
    clock.first = step;
    clock.end = end;
    if (std::isinf(end)) {
      clock.count = static_cast<long>(most_count);
      clock.dt = limit;
      return clock;
    }
    const double count = std::ceil((end - time) / limit * (1.0 - 1e-12));
    if (!(count < most_count)) throw std::invalid_argument("more steps than can be counted");
    clock.count = std::max(1L, static_cast<long>(count));
    clock.dt = (end - time) / static_cast<double>(clock.count);
    return clock;
  }
  [[nodiscard]] long last() const { return first + count; }
  [[nodiscard]] double time(long step) const {
    return step == last() ? end : start + static_cast<double>(step - first) * dt;
  }

  /// Calls `visit(name, value)` for each of the above.
  template <class Visit>
  void visit(const Visit& visit) {
    visit("start", start);
    visit("first", first);
    visit("count", count);
    visit("end", end);
    visit("dt", dt);
  }
};

}  // namespace tlsph

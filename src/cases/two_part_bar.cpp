#include "two_part_bar.hpp"

#include <compare>
#include <map>

namespace tlsph {

TwoPartWave::TwoPartWave(const TwoPartBar& bar, double end) : bar_(bar) {
  const double through_a = bar.interface / bar.speed_a;
  const double through_b = (bar.length - bar.interface) / bar.speed_b;
  const double back = bar.reflected();
  const double on = bar.transmitted();
  // Rays that have gone through A and B as often set out together, so their factors add up. In the
  // order of the ways behind them, none gets a share after it was followed.
  struct Key {
    int ways, ways_in_a;
    bool in_b, outward;
    // NOLINTNEXTLINE(modernize-use-nullptr): a comparison with zero that the compiler writes
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, double> waiting = {{{0, 0, false, true}, 1.0}};
  while (!waiting.empty()) {
    const auto [key, factor] = *waiting.begin();
    waiting.erase(waiting.begin());
    const auto [ways, in_a, in_b, outward] = key;
    const double start = in_a * through_a + (ways - in_a) * through_b;
    if (start > end) continue;
    rays_.push_back({in_b, outward, start, factor});
    const int next_in_a = in_a + (in_b ? 0 : 1);
    const auto send = [&, ways = ways, factor = factor](bool into_b, bool out, double share) {
      waiting[{ways + 1, next_in_a, into_b, out}] += share * factor;
    };
    if (!in_b && !outward) {
      send(false, true, -1.0);  // the loaded end is free for what comes back to it
    } else if (in_b && outward) {
      send(true, false, bar.fixed_end ? 1.0 : -1.0);
    } else if (!in_b) {
      send(false, false, back);
      send(true, true, on);
    } else {
      send(true, true, -back);
      send(false, false, 2.0 - on);  // (4.46) from B: 2/(1 + ratio)
    }
  }
}

double TwoPartWave::stress(double x, double t) const {
  const bool in_b = x > bar_.interface;
  const double from = in_b ? x - bar_.interface : x;
  const double to = in_b ? bar_.length - x : bar_.interface - x;
  const double speed = in_b ? bar_.speed_b : bar_.speed_a;
  double sum = 0.0;
  for (const Ray& ray : rays_)
    if (ray.in_b == in_b)
      sum += ray.factor * value(bar_.traction, t - ray.start - (ray.outward ? from : to) / speed);
  return sum;
}

}  // namespace tlsph

#include "tlsph/core/team_choice.hpp"

#include <algorithm>

namespace tlsph {
namespace {

/// Seconds and pieces that are enough to compare: some slices of a scheduler. The first comparison
/// takes less, for there may be little work at all; if it erred the next sees it.
constexpr double stretch = 0.01, first_stretch = 0.25 * stretch;
constexpr int fewest_pieces = 2;
/// Seconds between trials: at least, which bounds what they cost to a twentieth, and at most.
constexpr double shortest = 20.0 * stretch, longest = 16.0 * shortest;

/// By this factor slower than the other was: the machine has changed, no more waiting. It holds for
/// the other's first trial too.
constexpr double slower = 2.0;

}  // namespace

void TeamChoice::took(double seconds, double amount) {
  spent_ += seconds;
  amount_ += amount;
  since_ += seconds;
  ++pieces_;
  const bool first = cost_[0] == 0.0 || cost_[1] == 0.0;
  if (spent_ < (first ? first_stretch : stretch) || pieces_ < fewest_pieces) return;
  cost_[together_ ? 1 : 0] = spent_ / amount_;
  const double own = cost_[together_ ? 1 : 0];
  const double other = cost_[together_ ? 0 : 1];
  spent_ = amount_ = 0.0;
  pieces_ = 0;
  if (trial_) {
    trial_ = false;
    since_ = 0.0;
    // A team that slows down is seen at once, by its times; that it would be fast again is not.
    hold_ = own < other ? shortest : std::min(2.0 * hold_, longest);
    if (own >= other) together_ = !together_;
    if (together_) hold_ = longest;
  } else if (own > slower * other || since_ >= (own < other ? hold_ : shortest)) {
    hold_ = std::max(hold_, shortest);
    trial_ = true;
    together_ = !together_;
  }
}

}  // namespace tlsph

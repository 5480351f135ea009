#pragma once
/// \file
/// Whether a team of threads or one thread makes work that is repeated, by the time that each
/// takes.

#include <array>

namespace tlsph {

/// Begins with the team, tries one thread, keeps who was faster, and tries the other again now and
/// then: where other programs keep the cores busy a team may wait longer for its threads than one
/// thread needs for all of the work. It reads no clock: the times are given to it.
class TeamChoice {
 public:
  /// Whether the team is to make the next piece of work.
  [[nodiscard]] constexpr bool together() const { return together_; }
  /// The piece of work took so many seconds. `amount`: how much it was, in a unit of its own.
  void took(double seconds, double amount = 1.0);

 private:
  void change();

  bool together_ = true;
  bool trial_ = false;
  double spent_ = 0.0, amount_ = 0.0;  // in this stretch
  int pieces_ = 0;
  double since_ = 0.0, hold_ = 0.0;  // seconds since the last trial, and until the next
  std::array<double, 2> cost_{};     // of one thread, of the team; 0: not known yet
};

}  // namespace tlsph

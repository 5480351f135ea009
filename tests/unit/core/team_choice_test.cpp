#include "tlsph/core/team_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tlsph {
namespace {

/// Seconds of a piece of work at a time, by a team or by one thread.
using Machine = std::function<double(bool together, double now)>;

/// The work of one thread, in pieces; what it takes where a choice is made for each.
struct Spell {
  double seconds = 0.0;
  long pieces = 0, together = 0;
};

Spell run_for(TeamChoice& choice, const Machine& machine, double start, double end) {
  Spell run;
  for (double now = start; now < end; ++run.pieces) {
    const bool together = choice.together();
    const double seconds = machine(together, now);
    choice.took(seconds);
    now += seconds;
    run.seconds += seconds;
    run.together += together ? 1 : 0;
  }
  return run;
}

constexpr double piece = 20e-6;  // of one thread with a core of its own

double quiet(bool together, double) {
  return together ? 0.6 * piece : piece;
}
/// Other programs have the cores half of the time; a team waits for its threads.
double busy(bool together, double) {
  return together ? 80.0 * piece : 2.0 * piece;
}

TEST(TeamChoice, IsTheTeamOnAQuietMachine) {
  TeamChoice choice;

  const Spell run = run_for(choice, quiet, 0.0, 10.0);

  EXPECT_LE(run.seconds, 1.01 * 0.6 * piece * static_cast<double>(run.pieces));
}

TEST(TeamChoice, IsOneThreadWhereATeamWaits) {
  TeamChoice choice;

  const Spell run = run_for(choice, busy, 0.0, 10.0);

  EXPECT_LE(run.seconds, 1.1 * 2.0 * piece * static_cast<double>(run.pieces));
  EXPECT_FALSE(choice.together());
}

TEST(TeamChoice, CostsLittleInAShortRunOnABusyMachine) {
  TeamChoice choice;

  const Spell run = run_for(choice, busy, 0.0, 0.5);

  EXPECT_LE(run.seconds, 1.2 * 2.0 * piece * static_cast<double>(run.pieces));
}

TEST(TeamChoice, FollowsTheMachine) {
  TeamChoice choice;
  run_for(choice, quiet, 0.0, 5.0);
  ASSERT_TRUE(choice.together());

  const Spell change = run_for(choice, busy, 5.0, 5.5);
  const Spell after = run_for(choice, busy, 5.5, 10.0);
  run_for(choice, quiet, 10.0, 14.0);
  const Spell last = run_for(choice, quiet, 14.0, 20.0);

  EXPECT_LE(change.seconds, 1.2 * 2.0 * piece * static_cast<double>(change.pieces));
  EXPECT_LE(after.seconds, 1.1 * 2.0 * piece * static_cast<double>(after.pieces));
  EXPECT_GE(last.together, 0.95 * static_cast<double>(last.pieces));
}

/// A slice of a scheduler is long beside a piece: one thread runs or waits for whole slices, and a
/// team is held up by each slice of either of its threads.
TEST(TeamChoice, SeesThroughSlices) {
  constexpr double slice = 4e-3;
  const auto left = [](double now, double phase) {
    const double in_period = std::fmod(now + phase, 2.0 * slice);
    return in_period < slice ? 0.0 : 2.0 * slice - in_period;  // until this thread runs again
  };
  TeamChoice choice;

  const Spell run = run_for(
      choice,
      [&](bool together, double now) {
        const double own = left(now, 0.0);
        if (!together) return piece + own;
        return 0.6 * piece + std::max(own, left(now, 1.3 * slice)) + 3.0 * piece;
      },
      0.0, 10.0);

  EXPECT_LE(run.seconds, 1.2 * 2.0 * piece * static_cast<double>(run.pieces));
}

TEST(TeamChoice, ComparesPiecesOfAnyLength) {
  TeamChoice choice;

  for (int k = 0; k < 40; ++k) {
    const double amount = 1.0 + k % 3;
    choice.took(amount * (choice.together() ? 0.3 : 0.1), amount);
  }

  EXPECT_FALSE(choice.together());
}

}  // namespace
}  // namespace tlsph

#pragma once
/// \file
/// The threads of this process that share a task. A task has parts, more or fewer than there are
/// threads; who is free takes the next part, so nobody waits for a thread that has not begun, and
/// what a task computes does not depend on who makes which part.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>

#include "tlsph/core/team_choice.hpp"

namespace tlsph {

/// Threads wait for work, and for one another, in a loop for some ten microseconds, then asleep. A
/// process has one team; helpers start when they are first asked for, and end with the process.
class Team {
 public:
  /// While it lives the team is this thread's alone. `held` is false where somebody else has it, or
  /// this thread already.
  class Turn {
   public:
    Turn() : held(!shared().taken_.exchange(true, std::memory_order_acquire)) {}
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() {
      if (held) shared().taken_.store(false, std::memory_order_release);
    }
    const bool held;
  };

  /// task(part) for every part, once each, by so many threads of which this is one; in its turn
  /// only. A task must not throw.
  template <class Task>
  static void run(int threads, int parts, const Task& task) {
    shared().run_any(threads, parts, &task,
                     [](const void* any, int part) { (*static_cast<const Task*>(any))(part); });
  }

 private:
  using Call = void (*)(const void* task, int part);
  /// Part p of a task is offered in slot p modulo this.
  static constexpr int slots = 256;

  Team() = default;
  static Team& shared();
  void run_any(int threads, int parts, const void* task, Call call) noexcept;
  void hire(int threads);
  void help(int number) noexcept;
  void take_parts(unsigned job, int number) noexcept;

  std::atomic<bool> taken_ = false;
  int helpers_ = 0;
  // What the owner of the team changes; helpers that are late see it change under way.
  alignas(64) std::atomic<unsigned> job_ = 0;
  std::atomic<int> threads_ = 0, offered_ = 0;
  // Written before slots are offered, read by who has taken one.
  int parts_ = 0;
  const void* task_ = nullptr;
  Call call_ = nullptr;
  std::array<std::atomic<unsigned>, slots> offer_{};  // the job whose part is to be had, or 0
  alignas(64) std::atomic<int> unfinished_ = 0;       // slots
};

/// phase(part) for all parts of a phase, then of the next: by the team, or by this thread alone
/// while that is faster. `work`: in a unit of which the cost does not change.
template <class... Phases>
void in_parts(TeamChoice& choice, double work, int threads, int parts, const Phases&... phases) {
  const auto alone = [parts](const auto& phase) {
    for (int part = 0; part < parts; ++part) phase(part);
  };
  if (std::min(threads, parts) < 2) return (alone(phases), ...);
  const Team::Turn turn;
  if (!turn.held) return (alone(phases), ...);
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  if (choice.together())
    (Team::run(threads, parts, phases), ...);
  else
    (alone(phases), ...);
  choice.took(std::chrono::duration<double>(Clock::now() - start).count(), work);
}

}  // namespace tlsph

#include "tlsph/core/team.hpp"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

#include "tlsph/core/cpu_clock.hpp"
#include "tlsph/core/free_cores.hpp"

namespace tlsph {
namespace {

/// Looks before a thread sleeps, some ten microseconds: more than lies between two steps, less than
/// it costs anybody else who wants the core.
constexpr int looks = 1000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

template <class T>
void wait_while(const std::atomic<T>& value, T old) {
  for (int k = 0; k < looks; ++k) {
    if (value.load(std::memory_order_acquire) != old) return;
    pause();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

/// Never destroyed: its helpers sleep in it until the process ends.
Team& Team::shared() {
  static Team& team = *new Team;
  return team;
}

void Team::hire(int threads) {
  try {
    for (; helpers_ + 1 < threads; ++helpers_)
      std::thread([this, number = helpers_ + 1] { help(number); }).detach();
  } catch (const std::system_error&) {
    // As many as the system grants; whoever there is makes all parts.
  }
}

void Team::run_any(int threads, int parts, const void* task, Call call) noexcept {
  hire(std::min(threads, slots));
  const int offered = std::min(parts, slots);
  parts_ = parts;
  task_ = task;
  call_ = call;
  threads_.store(threads, std::memory_order_relaxed);
  offered_.store(offered, std::memory_order_relaxed);
  unfinished_.store(offered, std::memory_order_relaxed);
  const unsigned job = std::max(1U, job_.load(std::memory_order_relaxed) + 1);
  for (int slot = 0; slot < offered; ++slot)
    offer_[static_cast<std::size_t>(slot)].store(job, std::memory_order_release);
  job_.store(job, std::memory_order_release);
  job_.notify_all();
  take_parts(job, 0);
  for (int left = unfinished_.load(std::memory_order_acquire); left > 0;
       left = unfinished_.load(std::memory_order_acquire))
    wait_while(unfinished_, left);
}

void Team::help(int number) noexcept {
  for (unsigned seen = 0;;) {
    wait_while(job_, seen);
    seen = job_.load(std::memory_order_acquire);
    if (number < threads_.load(std::memory_order_relaxed)) take_parts(seen, number);
  }
}

/// Its own share first, the same from task to task, whose data its core may still hold; then what
/// others have not begun. A job that is over offers nothing.
void Team::take_parts(unsigned job, int number) noexcept {
  const int offered = offered_.load(std::memory_order_relaxed);
  const int threads = std::max(1, threads_.load(std::memory_order_relaxed));
  const int own = static_cast<int>(static_cast<long>(offered) * number / threads);
  for (int k = 0; k < offered; ++k) {
    const int slot = (own + k) % offered;
    std::atomic<unsigned>& offer = offer_[static_cast<std::size_t>(slot)];
    unsigned expected = job;
    if (offer.load(std::memory_order_relaxed) != job ||
        !offer.compare_exchange_strong(expected, 0, std::memory_order_acquire))
      continue;
    for (int part = slot; part < parts_; part += slots) call_(task_, part);
    if (unfinished_.fetch_sub(1, std::memory_order_acq_rel) == 1) unfinished_.notify_one();
  }
}

bool cores_are_free(int threads) {
  constexpr double work = 0.01;  // CPU seconds of each: some slices of a scheduler
  const Team::Turn turn;
  if (threads < 2 || !turn.held) return true;
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Team::run(threads, threads, [](int) {
    for (const double end = cpu_seconds() + work; cpu_seconds() < end;) pause();
  });
  return std::chrono::duration<double>(Clock::now() - start).count() < 1.5 * work;
}

}  // namespace tlsph

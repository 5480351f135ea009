#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tlsph {
namespace {

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole >= 3600) return fmt::format("{}h{:02}m", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{}m{:02}s", whole / 60, whole % 60);
  return fmt::format("{}s", whole);
}

/// An output that takes nothing stops no run: the report at its end finds out.
void say(const std::string& text) {
  (void)std::fputs(text.c_str(), stdout);
  (void)std::fflush(stdout);
}

}  // namespace

ProgressDisplay::Style ProgressDisplay::style_for(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDOUT_FILENO) != 0 ? Style::bar : Style::lines;
}

std::string ProgressDisplay::remaining(double share) const {
  const double done = share - first_share_;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  if (done <= 0.0 || passed.count() < 1.0) return "";
  return fmt::format(", {} left", duration(passed.count() * (1.0 - share) / done));
}

void ProgressDisplay::show(const Progress& progress) {
  if (style_ == Style::none || progress.end <= 0.0) return;
  const double share = std::clamp(progress.time / progress.end, 0.0, 1.0);
  if (first_share_ < 0.0) {
    first_share_ = share;
    start_ = std::chrono::steady_clock::now();
    tenths_ = static_cast<int>(share * 10.0);
  }
  const std::string where =
      fmt::format("{:3.0f} %  step {} of {}, t = {:.4g} s{}", share * 100.0, progress.step,
                  progress.steps, progress.time, remaining(share));
  if (style_ == Style::bar) {
    draw(share, where);
  } else if (static_cast<int>(share * 10.0) > tenths_) {
    tenths_ = static_cast<int>(share * 10.0);
    say(where + '\n');
  }
}

void ProgressDisplay::show(double share, const std::string& what) {
  if (style_ == Style::bar) draw(share, fmt::format("{:3.0f} %  {}", share * 100.0, what));
}

void ProgressDisplay::draw(double share, const std::string& text) {
  constexpr int width = 30;
  const int filled = static_cast<int>(share * width);
  // \x1b[K clears what a longer line left behind.
  say(fmt::format("\r[{:<{}}] {}\x1b[K", std::string(static_cast<std::size_t>(filled), '='), width,
                  text));
  visible_ = true;
}

void ProgressDisplay::clear() {
  if (!visible_) return;
  say("\r\x1b[K");
  visible_ = false;
}

}  // namespace tlsph

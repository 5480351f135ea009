#pragma once
/// \file
/// How far a run is: a bar on a terminal, a line for every tenth otherwise, or nothing.

#include <chrono>
#include <string>

#include "tlsph/simulation/simulation.hpp"

namespace tlsph {

class ProgressDisplay {
 public:
  enum class Style { none, lines, bar };
  static Style style_for(bool quiet);

  /// On the standard output, whose kind decides.
  explicit ProgressDisplay(bool quiet) : style_(style_for(quiet)) {}
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;
  ProgressDisplay(ProgressDisplay&&) = delete;
  ProgressDisplay& operator=(ProgressDisplay&&) = delete;
  /// Takes the bar away, so that what follows starts on a clean line.
  ~ProgressDisplay() { clear(); }

  void show(const Progress& progress);
  /// Of work that is no run: a bar on a terminal, nothing elsewhere.
  void show(double share, const std::string& what);
  void clear();

 private:
  void draw(double share, const std::string& text);
  [[nodiscard]] std::string remaining(double share) const;

  Style style_;
  bool visible_ = false;
  int tenths_ = 0;
  double first_share_ = -1.0;  // a resumed run does not start at zero
  std::chrono::steady_clock::time_point start_{};
};

}  // namespace tlsph

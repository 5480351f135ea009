#pragma once
/// \file
/// A 64-bit check sum of bytes: a checkpoint's own, and that of the body a checkpoint belongs to.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tlsph {

/// Check sum over 64-bit words: every word is mixed by a multiplication that can be undone, so a
/// single changed word always shows and any other change does with chance 1 − 2⁻⁶⁴ or so. Against
/// accidents, not against forgers. Each `add` begins a new word.
class CheckSum {
 public:
  CheckSum() = default;
  /// Goes on from the `value` of another.
  explicit CheckSum(std::uint64_t value) : sum_(value) {}
  void add(const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    for (; count >= 8; next += 8, count -= 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, next, 8);
      mix(word);
    }
    if (count == 0) return;
    std::uint64_t rest = 0;
    std::memcpy(&rest, next, count);
    mix(rest);
  }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  void mix(std::uint64_t word) {
    sum_ = std::rotl((sum_ ^ word) * 0x9E3779B97F4A7C15ULL, 29) + 0x632BE59BD9B4E019ULL;
  }
  std::uint64_t sum_ = 0xCBF29CE484222325ULL;
};

}  // namespace tlsph

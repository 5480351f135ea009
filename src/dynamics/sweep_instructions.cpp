#include "sweep_instructions.hpp"

#include <chrono>

namespace tlsph {

sweep::Level sweep::level_of(Instructions instructions) {
  switch (instructions) {
    case Instructions::baseline:
      return sweep::Level::baseline;
    case Instructions::avx2:
      return sweep::Level::avx2;
    case Instructions::avx512:
      return sweep::Level::avx512;
    case Instructions::widest:
      break;
  }
  return sweep::widest_level();
}

bool available(Instructions instructions) {
  return instructions == Instructions::widest ||
         sweep::level_of(instructions) <= sweep::widest_level();
}

double peak_multiply_adds(Index rounds) {
  using Clock = std::chrono::steady_clock;
  double sum = 0.0;
  const auto start = Clock::now();
  const Index done = sweep::kernels<1>(sweep::widest_level()).multiply_adds(rounds, sum);
  const std::chrono::duration<double> seconds = Clock::now() - start;
  return sum > 0.0 ? static_cast<double>(done) / seconds.count() : 0.0;
}

std::string widest_instructions() {
  switch (sweep::widest_level()) {
    case sweep::Level::avx512:
      return "avx512";
    case sweep::Level::avx2:
      return "avx2";
    case sweep::Level::baseline:
      break;
  }
  return "baseline";
}

}  // namespace tlsph

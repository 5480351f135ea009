#include "loops.hpp"

#include <array>

#include "tlsph/core/cpu_clock.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {
namespace {

Instructions widest() {
#ifdef TLSPH_X86
  __builtin_cpu_init();
  // By features: clang knows the levels x86-64-v3 and -v4 by name only from later versions on.
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (avx2 && avx512) return Instructions::avx512;
  if (avx2) return Instructions::avx2;
#endif
  return Instructions::baseline;
}

}  // namespace

bool available(Instructions instructions) {
  return instructions <= widest();
}

std::string widest_instructions() {
  constexpr std::array names = {"widest", "baseline", "avx2", "avx512"};
  return names[static_cast<std::size_t>(widest())];
}

double peak_multiply_adds(Index rounds) {
  double sum = 0.0;
  const double start = cpu_seconds();
  const Index done = sweep::loops<1>(Instructions::widest).multiply_adds(rounds, sum);
  const double seconds = cpu_seconds() - start;
  return sum > 0.0 ? static_cast<double>(done) / seconds : 0.0;
}

template <int D>
const sweep::Loops<D>& sweep::loops([[maybe_unused]] Instructions instructions) {
#ifdef TLSPH_X86
  if (instructions == Instructions::widest) instructions = widest();
  if (instructions == Instructions::avx512) return avx512_loops<D>();
  if (instructions == Instructions::avx2) return avx2_loops<D>();
#endif
  return baseline_loops<D>();
}

template const sweep::Loops<1>& sweep::loops<1>(Instructions);
template const sweep::Loops<2>& sweep::loops<2>(Instructions);

}  // namespace tlsph

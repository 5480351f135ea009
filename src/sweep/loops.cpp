#include "loops.hpp"

namespace tlsph::sweep {

#define TLSPH_DECLARE(set)              \
  extern const Loops<1> set##_loops_1d; \
  extern const Loops<2> set##_loops_2d;
TLSPH_DECLARE(baseline)
#ifdef TLSPH_X86
TLSPH_DECLARE(avx2)
TLSPH_DECLARE(avx512)
#endif
#undef TLSPH_DECLARE

Level widest_level() {
#ifdef TLSPH_X86
  __builtin_cpu_init();
  // By features: clang knows the levels x86-64-v3 and -v4 by name only from later versions on.
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl");
  if (avx2 && avx512) return Level::avx512;
  if (avx2) return Level::avx2;
#endif
  return Level::baseline;
}

template <>
const Loops<1>& loops<1>([[maybe_unused]] Level level) {
#ifdef TLSPH_X86
  if (level == Level::avx512) return avx512_loops_1d;
  if (level == Level::avx2) return avx2_loops_1d;
#endif
  return baseline_loops_1d;
}

template <>
const Loops<2>& loops<2>([[maybe_unused]] Level level) {
#ifdef TLSPH_X86
  if (level == Level::avx512) return avx512_loops_2d;
  if (level == Level::avx2) return avx2_loops_2d;
#endif
  return baseline_loops_2d;
}

}  // namespace tlsph::sweep

#include "sweep_kernels.hpp"

namespace tlsph::sweep {

#define TLSPH_DECLARE(set)                  \
  extern const Kernels<1> set##_kernels_1d; \
  extern const Kernels<2> set##_kernels_2d;
TLSPH_DECLARE(baseline)
#ifdef TLSPH_X86
TLSPH_DECLARE(avx2)
TLSPH_DECLARE(avx512)
#endif
#undef TLSPH_DECLARE

Level widest_level() {
#ifdef TLSPH_X86
  __builtin_cpu_init();
  if (__builtin_cpu_supports("x86-64-v4")) return Level::avx512;
  if (__builtin_cpu_supports("x86-64-v3")) return Level::avx2;
#endif
  return Level::baseline;
}

template <>
const Kernels<1>& kernels<1>([[maybe_unused]] Level level) {
#ifdef TLSPH_X86
  if (level == Level::avx512) return avx512_kernels_1d;
  if (level == Level::avx2) return avx2_kernels_1d;
#endif
  return baseline_kernels_1d;
}

template <>
const Kernels<2>& kernels<2>([[maybe_unused]] Level level) {
#ifdef TLSPH_X86
  if (level == Level::avx512) return avx512_kernels_2d;
  if (level == Level::avx2) return avx2_kernels_2d;
#endif
  return baseline_kernels_2d;
}

}  // namespace tlsph::sweep

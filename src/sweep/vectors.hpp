#pragma once
/// \file
/// Vectors of TLSPH_LANES doubles, by the extensions that GCC and Clang share.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include <cstdint>
#include <cstring>
#if TLSPH_LANES > 2
#include <immintrin.h>
#endif

#include "loops.hpp"

namespace tlsph::sweep {
namespace {

constexpr Index lanes = TLSPH_LANES;
using Real = double __attribute__((vector_size(TLSPH_LANES * 8)));
using Whole = std::int64_t __attribute__((vector_size(TLSPH_LANES * 8)));
using Pair = double __attribute__((vector_size(16)));

#define TLSPH_INLINE [[gnu::always_inline]] inline

template <class V>
TLSPH_INLINE V load(const double* from) {
  V value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
template <class V>
TLSPH_INLINE void store(double* to, const V& value) {
  std::memcpy(to, &value, sizeof value);
}
TLSPH_INLINE Real all(double value) {
  return Real{} + value;
}

/// The first `count` ≤ lanes doubles, others zero.
TLSPH_INLINE Real load_part(const double* from, Index count) {
#if TLSPH_LANES == 8
  return (Real)_mm512_maskz_loadu_pd(static_cast<__mmask8>((1U << count) - 1U), from);
#else
  Real value{};
  for (Index lane = 0; lane < lanes; ++lane)
    if (lane < count) value[lane] = from[lane];
  return value;
#endif
}
TLSPH_INLINE void store_part(double* to, Index count, Real value) {
#if TLSPH_LANES == 8
  _mm512_mask_storeu_pd(to, static_cast<__mmask8>((1U << count) - 1U), (__m512d)value);
#else
  for (Index lane = 0; lane < lanes; ++lane)
    if (lane < count) to[lane] = value[lane];
#endif
}

/// The first `count` ≤ lanes doubles of a vector, others zero.
TLSPH_INLINE Real part_of(Real value, Index count) {
#if TLSPH_LANES == 8
  return (Real)_mm512_maskz_mov_pd(static_cast<__mmask8>((1U << count) - 1U), (__m512d)value);
#else
  for (Index lane = 0; lane < lanes; ++lane)
    if (lane >= count) value[lane] = 0.0;
  return value;
#endif
}

TLSPH_INLINE Real absolute(Real value) {
  Whole bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits &= std::int64_t{0x7fffffffffffffff};
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Asks for the line that many doubles ahead: laws and products keep the processor from noticing
/// in time that u and v are read in order (a tenth to a quarter of a step of 5e5 particles).
TLSPH_INLINE void fetch_to_write(const double* at) {
  constexpr Index doubles_ahead = 1024;
  __builtin_prefetch(at + doubles_ahead, 1);
}

/// A number that the compiler knows.
template <int N>
struct Constant {
  static constexpr int value = N;
};

/// True where every lane is.
TLSPH_INLINE bool everywhere(Whole lane) {
#if TLSPH_LANES == 8
  return _mm512_movepi64_mask((__m512i)lane) == 0xff;
#elif TLSPH_LANES == 4
  return _mm256_movemask_pd((__m256d)lane) == 0xf;
#else
  return (lane[0] & lane[1]) != 0;
#endif
}

/// The components of one row: a pair in 2D.
template <int D>
struct RowValue;
template <>
struct RowValue<1> {
  using Type = double;
};
template <>
struct RowValue<2> {
  using Type = Pair;
};

}  // namespace
}  // namespace tlsph::sweep

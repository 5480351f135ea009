#pragma once
/// \file
/// Vectors of TLSPH_LANES doubles, by the extensions that GCC and Clang share.
/// Local to each source that includes it, as everything here is (sweep_kernels_body.hpp).

#include <cstdint>
#include <cstring>

#include "sweep_kernels.hpp"

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

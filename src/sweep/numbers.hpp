#pragma once
/// \file
/// Vectors of material points as the numbers of a law (tlsph/materials/numbers.hpp).
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "tlsph/materials/law_list.hpp"
#include "vectors.hpp"

namespace tlsph::sweep {
namespace {

/// ln(1 + e) to full relative precision for small e, after fdlibm's log1p (Sun Microsystems 1993):
/// 1 + e = 2^k (1 + f), and e itself is f for k = 0. It needs 1/(2 + f), the caller 1/J: one
/// division serves both.
TLSPH_INLINE Real log_volume(Real e, Real J, Real& inverse) {
  constexpr std::uint64_t root_half = 0x3FE6A09E667F3BCD;  // of √½
  constexpr std::uint64_t bias = std::uint64_t{1024} << 52;
  using Unsigned = std::uint64_t __attribute__((vector_size(TLSPH_LANES * 8)));
  Unsigned bits;  // without a sign: those of J < 0, whose lanes are lost, wrap around
  std::memcpy(&bits, &J, sizeof bits);
  const Whole k = (Whole)((bits - root_half + bias) >> 52) - 1024;
  const Unsigned mantissa_bits = bits - ((Unsigned)k << 52);
  Real mantissa;
  std::memcpy(&mantissa, &mantissa_bits, sizeof mantissa);
  const Real f = k == 0 ? e : mantissa - 1.0;
  // k as a number: its bits in the mantissa of 1.5·2^52
  const Whole shifted = k + 0x4338000000000000;
  Real exponent;
  std::memcpy(&exponent, &shifted, sizeof exponent);
  exponent -= 0x1.8p52;
  const Real both = 1.0 / (J * (2.0 + f));
  inverse = both * (2.0 + f);
  const Real s = f * J * both;
  const Real z = s * s;
  Real series = all(1.479819860511658591e-01);
  series = series * z + 1.531383769920937332e-01;
  series = series * z + 1.818357216161805012e-01;
  series = series * z + 2.222219843214978396e-01;
  series = series * z + 2.857142874366239149e-01;
  series = series * z + 3.999999999940941908e-01;
  series = series * z + 6.666666666666735130e-01;
  series *= z;
  const Real half_square = 0.5 * f * f;
  const Real low = exponent * 1.90821492927058770002e-10;
  return exponent * 6.93147180369123816490e-01 -
         ((half_square - (s * (half_square + series) + low)) - f);
}

/// Up to here the series below is good to the last bit; nearly all that is elastic and not rubber.
constexpr double small_change = 0x1p-4;

/// The same for |e| ≤ small_change in all lanes: 2 artanh(e/(2 + e)), by its series.
TLSPH_INLINE Real log_of_small_change(Real e, Real J, Real& inverse) {
  const Real both = 1.0 / (J * (2.0 + e));
  inverse = both * (2.0 + e);
  const Real s = e * J * both;
  const Real z = s * s;
  Real series = all(2.0 / 9.0);
  series = series * z + 2.0 / 7.0;
  series = series * z + 2.0 / 5.0;
  series = series * z + 2.0 / 3.0;
  return s * (2.0 + z * series);
}

}  // namespace
}  // namespace tlsph::sweep

/// Its vectors are those of one instruction set: no other source knows the type.
template <>
struct tlsph::Numbers<tlsph::sweep::Real> {
  using Real = sweep::Real;
  using Mask = sweep::Whole;
  TLSPH_INLINE static Real all(double value) { return sweep::all(value); }
  TLSPH_INLINE static bool everywhere(Mask mask) { return sweep::everywhere(mask); }
  TLSPH_INLINE static Real magnitude(Real value) { return sweep::absolute(value); }
  TLSPH_INLINE static Real root(Real value) {
    for (int lane = 0; lane < TLSPH_LANES; ++lane) value[lane] = __builtin_sqrt(value[lane]);
    return value;
  }
  /// ln J and 1/J; `good` loses the lanes where J ≤ 0 or is not finite.
  TLSPH_INLINE static Real log_and_inverse(Real e, Real& inverse, Mask& good) {
    const Real J = 1.0 + e;
    if (everywhere((e < sweep::small_change) & (e > -sweep::small_change)))
      return sweep::log_of_small_change(e, J, inverse);
    good &= (J > 0.0) & (J < huge);
    return sweep::log_volume(e, J, inverse);
  }
};

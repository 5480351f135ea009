#pragma once
/// \file
/// Laws of a vector of material points: strain in, stress out, in the same place.
/// Local to each source that includes it, as everything here is (sweep_kernels_body.hpp).

#include "sweep_vectors.hpp"

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

constexpr double huge = 0x1p1000;

/// ln J and 1/J; `good` loses the lanes where J ≤ 0 or is not finite.
TLSPH_INLINE Real log_and_inverse(Real e, Real J, Real& inverse, Whole& good) {
  if (everywhere((e < small_change) & (e > -small_change)))
    return log_of_small_change(e, J, inverse);
  good &= (J > 0.0) & (J < huge);
  return log_volume(e, J, inverse);
}

/// Stresses from displacement gradients, component by component; `good` loses the lanes whose state
/// is none.
struct LinearElastic {
  static constexpr bool reads_volume = false;
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    good &= absolute(h) < huge;
    h *= lambda + 2.0 * mu;
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real trace = h00 + h11;
    const Real shear = mu * (h01 + h10);
    good &= absolute(trace) + absolute(h00) + absolute(shear) < huge;
    h00 = lambda * trace + 2.0 * mu * h00;
    h11 = lambda * trace + 2.0 * mu * h11;
    h01 = shear;
    h10 = shear;
  }
};

/// `Free`: the missing directions have no stress, which needs 1 + 2E_33 = 1 − λ tr(E)/μ > 0 with
/// the reduced λ.
template <bool Free>
struct StVenantKirchhoff {
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    good &= (h > -1.0) & (h < huge);
    const Real strain = h + 0.5 * h * h;
    if constexpr (Free) good &= lambda * strain < mu;
    h = (1.0 + h) * (lambda + 2.0 * mu) * strain;
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real e = h00 + h11 + (h00 * h11 - h01 * h10);
    good &= (e > -1.0) & (e < huge);
    const Real e00 = h00 + 0.5 * (h00 * h00 + h10 * h10);
    const Real e11 = h11 + 0.5 * (h01 * h01 + h11 * h11);
    const Real e01 = 0.5 * (h01 + h10 + (h00 * h01 + h10 * h11));
    const Real pressure = lambda * (e00 + e11);
    if constexpr (Free) good &= pressure < mu;
    const Real s00 = pressure + 2.0 * mu * e00;
    const Real s11 = pressure + 2.0 * mu * e11;
    const Real s01 = 2.0 * mu * e01;
    const Real p00 = s00 + (h00 * s00 + h01 * s01);
    const Real p01 = s01 + (h00 * s01 + h01 * s11);
    const Real p10 = s01 + (h10 * s00 + h11 * s01);
    const Real p11 = s11 + (h10 * s01 + h11 * s11);
    h00 = p00;
    h01 = p01;
    h10 = p10;
    h11 = p11;
  }
};

/// P = μ (F − F⁻ᵀ) + p F⁻ᵀ as in materials/neo_hookean.hpp, p = λ ln J where missing directions are
/// unstrained, or `Free` of them without stress.
template <int Free>
struct NeoHookean {
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    const Real J = 1.0 + h;
    Real inverse;
    const Real log = log_and_inverse(h, J, inverse, good);
    h = (mu * (h * J + h) + pressure(log, good)) * inverse;
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real e = h00 + h11 + (h00 * h11 - h01 * h10);
    const Real J = 1.0 + e;
    Real inverse;
    const Real log = log_and_inverse(e, J, inverse, good);
    const Real normal = pressure(log, good) * inverse;
    const Real shear_modulus = mu * inverse;
    const Real stretch = shear_modulus * (h00 - h11);
    const Real shear = shear_modulus * (h01 + h10);
    const Real dilation = shear_modulus * e;
    const Real f00 = 1.0 + h00;
    const Real f11 = 1.0 + h11;
    const Real p00 = dilation * f00 + stretch + normal * f11;
    const Real p11 = dilation * f11 - stretch + normal * f00;
    const Real p01 = dilation * h01 + shear - normal * h10;
    const Real p10 = dilation * h10 + shear - normal * h01;
    h00 = p00;
    h01 = p01;
    h10 = p10;
    h11 = p11;
  }

  /// p = λ ln J of the three-dimensional body, from ln J of the model's directions.
  TLSPH_INLINE Real pressure(Real log, Whole& good) const {
    if constexpr (Free == 0)
      return lambda * log;
    else
      return pressure_of_free(log, good);
  }

  /// dp/d(ln J of the model's directions) where p is the pressure; μ(1 + c) = μ − p.
  TLSPH_INLINE Real stiffness([[maybe_unused]] Real pressure) const {
    if constexpr (Free == 0)
      return lambda;
    else
      return lambda * (mu - pressure) / (mu - pressure + 0.5 * Free * lambda);
  }

 private:
  /// −μ c of c = s² − 1, s the common stretch of the free directions: by Newton,
  ///
  ///     g(c) = μ c + λ (ln J + Free/2 ln(1 + c)) = 0,
  ///
  /// which grows and is concave for λ ≥ 0: from the second iterate on the way goes up to the root.
  TLSPH_INLINE Real pressure_of_free(Real log, Whole& good) const {
    constexpr int most_iterations = 60;
    constexpr double half = 0.5 * Free;
    const auto at_least = [](Real value, Real bound) __attribute__((always_inline)) {
      return value > bound ? value : bound;
    };
    Real c = at_least(-log * lambda / (mu + half * lambda), all(-0.9));
    Whole found{};
    for (int iteration = 0; iteration < most_iterations && !everywhere(found); ++iteration) {
      Real inverse;
      const Real transverse = log_and_inverse(c, 1.0 + c, inverse, good);
      const Real step =
          (mu * c + lambda * (log + half * transverse)) / (mu + half * lambda * inverse);
      found = absolute(step) <= 1e-9 * absolute(c);  // the next would be below rounding
      c = at_least(c - step, 0.1 * (1.0 + c) - 1.0);
    }
    good &= found;
    return -mu * c;
  }
};

// Points come in an order of their own, pairs of a lane's halves, which a pointwise law does not
// mind: no shuffle crosses them. `point_of_lane` is that order.
#if TLSPH_LANES == 8
constexpr Whole point_of_lane_2d = {0, 4, 1, 5, 2, 6, 3, 7};
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
#elif TLSPH_LANES == 4
constexpr Whole point_of_lane_2d = {0, 2, 1, 3};
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
#else
constexpr Whole point_of_lane_2d = {0, 1};
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 2);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 3);
}
#endif

/// A vector of points in registers: H_a at `field[a]`, its components interleaved, becomes P_a.
template <int D, class Law>
TLSPH_INLINE void law_of(const Law& law, Real (&field)[D][D], Whole& good) {
  if constexpr (D == 1) {
    law(field[0][0], good);
  } else {
    Real h00 = evens(field[0][0], field[0][1]), h10 = odds(field[0][0], field[0][1]);
    Real h01 = evens(field[1][0], field[1][1]), h11 = odds(field[1][0], field[1][1]);
    law(h00, h10, h01, h11, good);
    field[0][0] = evens(h00, h10);
    field[0][1] = odds(h00, h10);
    field[1][0] = evens(h01, h11);
    field[1][1] = odds(h01, h11);
  }
}

/// The same in memory.
template <int D, class Law>
TLSPH_INLINE void law_at(const Law& law, double* const* field, Whole& good) {
  Real value[D][D];
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) value[a][c] = load<Real>(field[a] + c * lanes);
  law_of<D>(law, value, good);
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) store(field[a] + c * lanes, value[a][c]);
}

template <int D, class Law>
bool apply_law(const LawConstants& constants, double* const* fields, Index first, Index count) {
  const Law law{all(constants.lambda), all(constants.mu)};
  Whole good = ~Whole{};
  double* field[D];
  for (int a = 0; a < D; ++a) field[a] = fields[a] + first * D;
  Index at = 0;
  for (; at + lanes <= count; at += lanes) {
    law_at<D>(law, field, good);
    for (int a = 0; a < D; ++a) field[a] += lanes * D;
  }
  if (at < count) {
    const auto part = [&](int c) {
      const Index doubles = (count - at) * D - c * lanes;
      return doubles < 0 ? 0 : doubles < lanes ? doubles : lanes;
    };
    Real value[D][D];
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) value[a][c] = load_part(field[a] + c * lanes, part(c));
    law_of<D>(law, value, good);
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) store_part(field[a] + c * lanes, part(c), value[a][c]);
  }
  return everywhere(good);
}

}  // namespace
}  // namespace tlsph::sweep

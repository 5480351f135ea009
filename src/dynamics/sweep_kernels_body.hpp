/// \file
/// Included by one source an instruction set, which defines TLSPH_LANES, the doubles of a vector.
/// Everything is local to that source.

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

// ---- products -----------------------------------------------------------------------------------

/// `Chunk` vectors of rows at once; sums stay in registers. Two sums a direction where there is but
/// one vector, or every addition would wait for the last.
template <int Directions, int Chunk>
TLSPH_INLINE void gradient_chunk(const int* offset, const double* weight, int entries, int D,
                                 const double* x, double* const* out, Index at) {
  constexpr int parts = Chunk == 1 ? 2 : 1;
  Real sum[parts][Directions][Chunk] = {};
  const auto add = [&](int k, int part) __attribute__((always_inline)) {
    const double* from = x + static_cast<Index>(offset[k]) * D;
    for (int c = 0; c < Chunk; ++c) {
      const Real value = load<Real>(from + c * lanes);
      for (int a = 0; a < Directions; ++a) sum[part][a][c] += weight[k * Directions + a] * value;
    }
  };
  int k = 0;
  for (; k + parts <= entries; k += parts)
    for (int part = 0; part < parts; ++part) add(k + part, part);
  if (k < entries) add(k, 0);
  for (int a = 0; a < Directions; ++a)
    for (int c = 0; c < Chunk; ++c) {
      Real total = sum[0][a][c];
      if constexpr (parts == 2) total += sum[1][a][c];
      store(out[a] + at + c * lanes, total);
    }
}

template <int D, int Directions>
TLSPH_INLINE void gradient_stencil(const Table& table, const RowRun& run, const double* u,
                                   Index size, const Window& window) {
  const int begin = table.stencil_start[run.stencil];
  const int entries = table.stencil_start[run.stencil + 1] - begin;
  const int* offset = table.offset + begin;
  const double* weight = table.stencil_weight + static_cast<Index>(begin) * Directions;
  const double* x = u + static_cast<Index>(run.column) * D;
  double* out[Directions];
  for (int a = 0; a < Directions; ++a) out[a] = window.direction[a] + (run.first - window.base) * D;
  const Index length = static_cast<Index>(run.count) * D;
  Index at = 0;
  const auto chunk = [&](double* const* to, Index position) __attribute__((always_inline)) {
    gradient_chunk<Directions, 1>(offset, weight, entries, D, x + position, to, position);
  };
  for (; at + 4 * lanes <= length; at += 4 * lanes)
    gradient_chunk<Directions, 4>(offset, weight, entries, D, x + at, out, at);
  for (; at + 2 * lanes <= length; at += 2 * lanes)
    gradient_chunk<Directions, 2>(offset, weight, entries, D, x + at, out, at);
  for (; at + lanes <= length; at += lanes) chunk(out, at);
  if (at == length) return;
  // The last vector may read beyond the run, not beyond the field.
  const Index furthest = static_cast<Index>(run.column + table.reach[run.stencil]) * D + at + lanes;
  if (furthest <= size) return chunk(out, at);
  for (; at < length; ++at)
    for (int a = 0; a < Directions; ++a) {
      double sum = 0.0;
      for (int k = 0; k < entries; ++k)
        sum += weight[k * Directions + a] * x[static_cast<Index>(offset[k]) * D + at];
      out[a][at] = sum;
    }
}

template <int D, int Directions, class Weight>
TLSPH_INLINE void gradient_general(const Table& table, const Weight* weights, const RowRun& run,
                                   const double* u, const Window& window) {
  using Value = typename RowValue<D>::Type;
  // Single weights do not sum to zero; differences keep what a rigid motion must not make.
  constexpr bool differences_only = sizeof(Weight) < sizeof(double);
  for (Index row = run.first; row < run.first + run.count; ++row) {
    Value sum[2][Directions] = {};
    const Index end = table.row_start[row + 1];
    Index k = table.row_start[row];
    Value reference{};
    if (differences_only && k < end)
      reference = load<Value>(u + static_cast<Index>(table.column[k]) * D);
    const auto add = [&](Index entry, int part) __attribute__((always_inline)) {
      Value value = load<Value>(u + static_cast<Index>(table.column[entry]) * D);
      if constexpr (differences_only) value -= reference;
      for (int a = 0; a < Directions; ++a)
        sum[part][a] += static_cast<double>(weights[entry * Directions + a]) * value;
    };
    for (; k + 2 <= end; k += 2) {
      add(k, 0);
      add(k + 1, 1);
    }
    if (k < end) add(k, 0);
    for (int a = 0; a < Directions; ++a)
      store(window.direction[a] + (row - window.base) * D, sum[0][a] + sum[1][a]);
  }
}

template <int D, int Directions>
void gradient(const Table& table, Runs runs, const double* u, Index size, Window window) {
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    if (run.stencil != no_stencil)
      gradient_stencil<D, Directions>(table, run, u, size, window);
    else if (table.weight_single != nullptr)
      gradient_general<D, Directions>(table, table.weight_single, run, u, window);
    else
      gradient_general<D, Directions>(table, table.weight, run, u, window);
  }
}

template <int Directions, int Chunk>
TLSPH_INLINE void divergence_chunk(const int* offset, const double* weight, int entries, int D,
                                   const double* const* P, double* out, Index at) {
  // As many sums as directions: they do not wait for each other.
  constexpr int parts = Chunk >= 4 ? 1 : Directions;
  Real sum[parts][Chunk] = {};
  for (int k = 0; k < entries; ++k) {
    const Index from = static_cast<Index>(offset[k]) * D + at;
    for (int a = 0; a < Directions; ++a)
      for (int c = 0; c < Chunk; ++c)
        sum[a % parts][c] += weight[k * Directions + a] * load<Real>(P[a] + from + c * lanes);
  }
  for (int c = 0; c < Chunk; ++c) {
    Real total = sum[0][c];
    for (int part = 1; part < parts; ++part) total += sum[part][c];
    store(out + at + c * lanes, total);
  }
}

template <int D, int Directions>
TLSPH_INLINE void divergence_stencil(const Table& table, const RowRun& run, const Window& window,
                                     double* to, Index out_base) {
  const int begin = table.stencil_start[run.stencil];
  const int entries = table.stencil_start[run.stencil + 1] - begin;
  const int* offset = table.offset + begin;
  const double* weight = table.stencil_weight + static_cast<Index>(begin) * Directions;
  const double* P[Directions];
  for (int a = 0; a < Directions; ++a) P[a] = window.direction[a] + (run.column - window.base) * D;
  double* out = to + (run.first - out_base) * D;
  const Index length = static_cast<Index>(run.count) * D;
  Index at = 0;
  for (; at + 4 * lanes <= length; at += 4 * lanes)
    divergence_chunk<Directions, 4>(offset, weight, entries, D, P, out, at);
  for (; at + 2 * lanes <= length; at += 2 * lanes)
    divergence_chunk<Directions, 2>(offset, weight, entries, D, P, out, at);
  for (; at < length; at += lanes)
    divergence_chunk<Directions, 1>(offset, weight, entries, D, P, out, at);
}

template <int D, int Directions, class Weight>
TLSPH_INLINE void divergence_general(const Table& table, const Weight* weights, const RowRun& run,
                                     const Window& P, double* out, Index out_base) {
  using Value = typename RowValue<D>::Type;
  for (Index row = run.first; row < run.first + run.count; ++row) {
    Value sum[Directions] = {};
    for (Index k = table.row_start[row]; k < table.row_start[row + 1]; ++k) {
      const Index from = (static_cast<Index>(table.column[k]) - P.base) * D;
      for (int a = 0; a < Directions; ++a)
        sum[a] +=
            static_cast<double>(weights[k * Directions + a]) * load<Value>(P.direction[a] + from);
    }
    Value total = sum[0];
    for (int a = 1; a < Directions; ++a) total += sum[a];
    if (table.row_scale != nullptr) total *= table.row_scale[row];
    store(out + (row - out_base) * D, total);
  }
}

template <int D, int Directions>
void divergence(const Table& table, Runs runs, Window P, double* out, Index out_base) {
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    if (run.stencil != no_stencil)
      divergence_stencil<D, Directions>(table, run, P, out, out_base);
    else if (table.weight_single != nullptr)
      divergence_general<D, Directions>(table, table.weight_single, run, P, out, out_base);
    else
      divergence_general<D, Directions>(table, table.weight, run, P, out, out_base);
  }
}

template <int Chunk>
TLSPH_INLINE void differences_chunk(const int* offset, const double* weight, int entries, int D,
                                    const double* x, const double* self, double* out) {
  Real centre[Chunk];
  Real sum[Chunk] = {};
  for (int c = 0; c < Chunk; ++c) centre[c] = load<Real>(self + c * lanes);
  for (int k = 0; k < entries; ++k)
    for (int c = 0; c < Chunk; ++c)
      sum[c] +=
          weight[k] * (load<Real>(x + static_cast<Index>(offset[k]) * D + c * lanes) - centre[c]);
  for (int c = 0; c < Chunk; ++c) store(out + c * lanes, sum[c]);
}

template <int D>
TLSPH_INLINE void differences_row(const int* column, const double* weight, Index entries,
                                  const double* x, Index row, double scale, double* out) {
  using Value = typename RowValue<D>::Type;
  const Value self = load<Value>(x + row * D);
  Value sum[2] = {};
  for (Index k = 0; k < entries; ++k)
    sum[k & 1] += weight[k] * (load<Value>(x + static_cast<Index>(column[k]) * D) - self);
  store(out, (sum[0] + sum[1]) * scale);
}

template <int D>
void differences(const Table& table, Runs runs, const double* x, Index size, double* to,
                 Index out_base) {
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    double* out = to + (run.first - out_base) * D;
    if (run.stencil == no_stencil) {
      for (Index row = run.first; row < run.first + run.count; ++row, out += D) {
        const Index start = table.row_start[row];
        differences_row<D>(table.column + start, table.weight + start,
                           table.row_start[row + 1] - start, x, row,
                           table.row_scale != nullptr ? table.row_scale[row] : 1.0, out);
      }
      continue;
    }
    const int begin = table.stencil_start[run.stencil];
    const int entries = table.stencil_start[run.stencil + 1] - begin;
    const int* offset = table.offset + begin;
    const double* weight = table.stencil_weight + begin;
    const double* from = x + static_cast<Index>(run.column) * D;
    const double* self = x + static_cast<Index>(run.first) * D;
    const Index length = static_cast<Index>(run.count) * D;
    Index at = 0;
    for (; at + 4 * lanes <= length; at += 4 * lanes)
      differences_chunk<4>(offset, weight, entries, D, from + at, self + at, out + at);
    const Index furthest = static_cast<Index>(run.column + table.reach[run.stencil]) * D;
    for (; at < length && furthest + at + lanes <= size &&
           static_cast<Index>(run.first) * D + at + lanes <= size;
         at += lanes)
      differences_chunk<1>(offset, weight, entries, D, from + at, self + at, out + at);
    for (; at < length; ++at) {
      double sum = 0.0;
      for (int k = 0; k < entries; ++k)
        sum += weight[k] * (from[static_cast<Index>(offset[k]) * D + at] - self[at]);
      out[at] = sum;
    }
  }
}

// ---- laws ---------------------------------------------------------------------------------------

/// ln(1 + e) to full relative precision for small e, after fdlibm's log1p (Sun Microsystems 1993):
/// 1 + e = 2^k (1 + f), and e itself is f for k = 0.
TLSPH_INLINE Real log_volume(Real e, Real J) {
  constexpr std::int64_t root_half = 0x3FE6A09E667F3BCD;  // of √½
  constexpr std::int64_t bias = std::int64_t{1024} << 52;
  using Unsigned = std::uint64_t __attribute__((vector_size(TLSPH_LANES * 8)));
  Whole bits;
  std::memcpy(&bits, &J, sizeof bits);
  const Whole k = (Whole)(((Unsigned)(bits - root_half + bias)) >> 52) - 1024;
  const Whole mantissa_bits = bits - (k << 52);
  Real mantissa;
  std::memcpy(&mantissa, &mantissa_bits, sizeof mantissa);
  const Real f = k == 0 ? e : mantissa - 1.0;
  // k as a number: its bits in the mantissa of 1.5·2^52
  const Whole shifted = k + 0x4338000000000000;
  Real exponent;
  std::memcpy(&exponent, &shifted, sizeof exponent);
  exponent -= 0x1.8p52;
  const Real s = f / (2.0 + f);
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

constexpr double huge = 0x1p1000;

/// Stresses from displacement gradients, component by component; `good` loses the lanes whose state
/// is none.
struct LinearElastic {
  static constexpr bool reads_volume = false;
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    good &= h < huge;
    h *= lambda + 2.0 * mu;
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real trace = h00 + h11;
    const Real shear = mu * (h01 + h10);
    good &= trace < huge;
    h00 = lambda * trace + 2.0 * mu * h00;
    h11 = lambda * trace + 2.0 * mu * h11;
    h01 = shear;
    h10 = shear;
  }
};

struct StVenantKirchhoff {
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    good &= (h > -1.0) & (h < huge);
    h = (1.0 + h) * (lambda + 2.0 * mu) * (h + 0.5 * h * h);
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real e = h00 + h11 + (h00 * h11 - h01 * h10);
    good &= (e > -1.0) & (e < huge);
    const Real e00 = h00 + 0.5 * (h00 * h00 + h10 * h10);
    const Real e11 = h11 + 0.5 * (h01 * h01 + h11 * h11);
    const Real e01 = 0.5 * (h01 + h10 + (h00 * h01 + h10 * h11));
    const Real pressure = lambda * (e00 + e11);
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

/// P = μ (F − F⁻ᵀ) + λ ln J F⁻ᵀ as in materials/neo_hookean.hpp, missing directions unstrained.
struct NeoHookean {
  Real lambda, mu;
  TLSPH_INLINE void operator()(Real& h, Whole& good) const {
    const Real J = 1.0 + h;
    good &= (J > 0.0) & (J < huge);
    h = (mu * (h * J + h) + lambda * log_volume(h, J)) / J;
  }
  TLSPH_INLINE void operator()(Real& h00, Real& h10, Real& h01, Real& h11, Whole& good) const {
    const Real e = h00 + h11 + (h00 * h11 - h01 * h10);
    const Real J = 1.0 + e;
    good &= (J > 0.0) & (J < huge);
    const Real inverse = 1.0 / J;
    const Real pressure = lambda * log_volume(e, J) * inverse;
    const Real shear_modulus = mu * inverse;
    const Real stretch = shear_modulus * (h00 - h11);
    const Real shear = shear_modulus * (h01 + h10);
    const Real dilation = shear_modulus * e;
    const Real f00 = 1.0 + h00;
    const Real f11 = 1.0 + h11;
    const Real p00 = dilation * f00 + stretch + pressure * f11;
    const Real p11 = dilation * f11 - stretch + pressure * f00;
    const Real p01 = dilation * h01 + shear - pressure * h10;
    const Real p10 = dilation * h10 + shear - pressure * h01;
    h00 = p00;
    h01 = p01;
    h10 = p10;
    h11 = p11;
  }
};

#if TLSPH_LANES == 8
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
}
TLSPH_INLINE Real low(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}
TLSPH_INLINE Real high(Real a, Real b) {
  return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}
#elif TLSPH_LANES == 4
// Points come in another order, 0 2 1 3, which a pointwise law does not mind: one shuffle less.
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
TLSPH_INLINE Real low(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TLSPH_INLINE Real high(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
#else
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 2);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 3);
}
TLSPH_INLINE Real low(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 2);
}
TLSPH_INLINE Real high(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 3);
}
#endif

/// A vector of points.
template <int D, class Law>
TLSPH_INLINE void law_at(const Law& law, double* const* field, Whole& good) {
  if constexpr (D == 1) {
    Real h = load<Real>(field[0]);
    law(h, good);
    store(field[0], h);
  } else {
    const Real x0 = load<Real>(field[0]), x1 = load<Real>(field[0] + lanes);
    const Real y0 = load<Real>(field[1]), y1 = load<Real>(field[1] + lanes);
    Real h00 = evens(x0, x1), h10 = odds(x0, x1);
    Real h01 = evens(y0, y1), h11 = odds(y0, y1);
    law(h00, h10, h01, h11, good);
    store(field[0], low(h00, h10));
    store(field[0] + lanes, high(h00, h10));
    store(field[1], low(h01, h11));
    store(field[1] + lanes, high(h01, h11));
  }
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
    double rest[D][lanes * D] = {};
    double* padded[D];
    for (int a = 0; a < D; ++a) {
      padded[a] = rest[a];
      std::memcpy(rest[a], field[a], static_cast<std::size_t>((count - at) * D) * sizeof(double));
    }
    law_at<D>(law, padded, good);
    for (int a = 0; a < D; ++a)
      std::memcpy(field[a], rest[a], static_cast<std::size_t>((count - at) * D) * sizeof(double));
  }
  std::int64_t every = -1;
  for (Index lane = 0; lane < lanes; ++lane) every &= good[lane];
  return every != 0;
}

// ---- update -------------------------------------------------------------------------------------

Index multiply_adds(Index count, double& sum) {
  constexpr int chains = 12;  // enough to hide the latency of any processor of today
  Real value[chains];
  for (int k = 0; k < chains; ++k) value[k] = all(1.0 + k);
  const Real factor = all(0.999);
  const Real term = all(0.001);
  for (Index n = 0; n < count; ++n)
    for (int k = 0; k < chains; ++k) value[k] = value[k] * factor + term;
  for (int k = 0; k < chains; ++k)
    for (Index lane = 0; lane < lanes; ++lane) sum += value[k][lane];
  return count * chains * lanes;
}

void subtract(Index size, const double* r, double* a) {
  Index at = 0;
  for (; at + lanes <= size; at += lanes) store(a + at, load<Real>(a + at) - load<Real>(r + at));
  for (; at < size; ++at) a[at] -= r[at];
}

double update(Index size, double kick, double dt, const double* a, double* v, double* u) {
  Index at = 0;
  Real most{};
  for (; at + lanes <= size; at += lanes) {
    const Real velocity = load<Real>(v + at) + kick * load<Real>(a + at);
    store(v + at, velocity);
    store(u + at, load<Real>(u + at) + dt * velocity);
    const Real speed = velocity < 0.0 ? -velocity : velocity;
    most = speed > most ? speed : most;
  }
  double largest = 0.0;
  for (Index lane = 0; lane < lanes; ++lane) largest = most[lane] > largest ? most[lane] : largest;
  for (; at < size; ++at) {
    v[at] += kick * a[at];
    u[at] += dt * v[at];
    const double speed = v[at] < 0.0 ? -v[at] : v[at];
    largest = speed > largest ? speed : largest;
  }
  return largest;
}

template <int D>
constexpr Kernels<D> make_kernels() {
  return {gradient<D, D>,
          gradient<D, D + 1>,
          divergence<D, D>,
          divergence<D, D + 1>,
          differences<D>,
          apply_law<D, LinearElastic>,
          apply_law<D, StVenantKirchhoff>,
          apply_law<D, NeoHookean>,
          multiply_adds,
          subtract,
          update};
}

#undef TLSPH_INLINE

}  // namespace
}  // namespace tlsph::sweep

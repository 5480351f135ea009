#pragma once
/// \file
/// Accelerations of nodes as one product of blocks with differences of places, and the moves they
/// make once no row needs the old places any more.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "nodes.hpp"

namespace tlsph::sweep {
namespace {

// A number in all lanes, or a pair in all of theirs.
TLSPH_INLINE Real spread(double value) {
  return all(value);
}
TLSPH_INLINE Real spread(Pair value) {
#if TLSPH_LANES == 8
  return (Real)_mm512_maskz_broadcast_f64x2(0xff, (__m128d)value);
#elif TLSPH_LANES == 4
  return (Real)_mm256_insertf128_pd(_mm256_castpd128_pd256((__m128d)value), (__m128d)value, 1);
#else
  return value;
#endif
}

/// D numbers, over and over.
template <int D>
TLSPH_INLINE Real repeated(const double* number) {
  return spread(load<typename RowValue<D>::Type>(number));
}

// A component's sum for the other one goes over to it.
TLSPH_INLINE Pair swapped(Pair value) {
  return __builtin_shufflevector(value, value, 1, 0);
}
#if TLSPH_LANES == 8
TLSPH_INLINE Real swapped(Real value) {
  return __builtin_shufflevector(value, value, 1, 0, 3, 2, 5, 4, 7, 6);
}
#elif TLSPH_LANES == 4
TLSPH_INLINE Real swapped(Real value) {
  return __builtin_shufflevector(value, value, 1, 0, 3, 2);
}
#endif

/// The stencil of a run of block rows.
template <int D>
struct BlockStencil : Stencil<block_weights<D>> {
  int mixed;

  BlockStencil(const RowWeights& table, const RowRun& run)
      : Stencil<block_weights<D>>(table, run), mixed(table.mixed[run.stencil]) {}
};

/// Weights of a stencil that the compiler knows the size of, in registers.
template <int D, int Entries, int Mixed>
struct KnownBlocks {
  static constexpr int entries = Entries, mixed = Mixed;
  Real same[Entries], other[Mixed > 0 ? Mixed : 1];

  TLSPH_INLINE explicit KnownBlocks(const BlockStencil<D>& stencil) {
    for (int k = 0; k < Entries; ++k) same[k] = repeated<D>(stencil.weight + k * block_weights<D>);
    for (int k = 0; k < Mixed; ++k)
      other[k] = repeated<D>(stencil.weight + k * block_weights<D> + D);
  }
  TLSPH_INLINE Real of_same(int k) const { return same[k]; }
  TLSPH_INLINE Real of_other(int k) const { return other[k]; }
};

/// Any others, read where they are.
template <int D>
struct AnyBlocks {
  int entries, mixed;
  const double* weight;

  TLSPH_INLINE explicit AnyBlocks(const BlockStencil<D>& stencil)
      : entries(stencil.entries), mixed(stencil.mixed), weight(stencil.weight) {}
  TLSPH_INLINE Real of_same(int k) const { return repeated<D>(weight + k * block_weights<D>); }
  TLSPH_INLINE Real of_other(int k) const { return repeated<D>(weight + k * block_weights<D> + D); }
};

/// Σ_k B_k (u_k − u) + g of `Chunk` vectors of rows; `total` adds up all that comes out.
template <int D, int Chunk, class Blocks>
TLSPH_INLINE void accelerations_chunk(const int* offset, const Blocks& blocks, const double* u,
                                      Real body_force, double* out, Real* total) {
  Real self[Chunk], sum[Chunk], other[Chunk] = {};
  for (int c = 0; c < Chunk; ++c) {
    self[c] = load<Real>(u + c * lanes);
    sum[c] = body_force;
  }
  for (int k = 0; k < blocks.mixed; ++k) {
    const double* from = u + static_cast<Index>(offset[k]) * D;
    for (int c = 0; c < Chunk; ++c) {
      const Real difference = load<Real>(from + c * lanes) - self[c];
      sum[c] += blocks.of_same(k) * difference;
      other[c] += blocks.of_other(k) * difference;
    }
  }
  for (int k = blocks.mixed; k < blocks.entries; ++k) {
    const double* from = u + static_cast<Index>(offset[k]) * D;
    for (int c = 0; c < Chunk; ++c)
      sum[c] += blocks.of_same(k) * (load<Real>(from + c * lanes) - self[c]);
  }
  for (int c = 0; c < Chunk; ++c) {
    if constexpr (D == 2) sum[c] += swapped(other[c]);
    total[c] += sum[c];
    store(out + c * lanes, sum[c]);
  }
}

/// One row.
template <int D>
TLSPH_INLINE typename RowValue<D>::Type acceleration_of_row(const BlockStencil<D>& stencil,
                                                            const double* u,
                                                            typename RowValue<D>::Type sum) {
  using Value = typename RowValue<D>::Type;
  const auto self = load<Value>(u);
  Value other{};
  for (int k = 0; k < stencil.entries; ++k) {
    const Value difference = load<Value>(u + static_cast<Index>(stencil.offset[k]) * D) - self;
    const double* weight = stencil.weight + k * block_weights<D>;
    sum += load<Value>(weight) * difference;
    if constexpr (D == 2) other += load<Value>(weight + D) * difference;
  }
  if constexpr (D == 2) sum += swapped(other);
  return sum;
}

/// Rows of a run whose vectors read no further than the field; how many they are.
template <int D, class Blocks>
TLSPH_INLINE Index accelerations_of_run(const BlockStencil<D>& stencil, const Blocks& blocks,
                                        const double* u, Index length, Index readable, Index reach,
                                        Real body_force, double* out, Real& total) {
  constexpr int chunk = 4 / D;
  Index at = 0;
  Real totals[chunk] = {};
  for (; at + chunk * lanes <= length; at += chunk * lanes) {
    if constexpr (D > 1)
      for (int c = 0; c < chunk; ++c) fetch_to_write(u + reach + at + c * lanes);
    accelerations_chunk<D, chunk>(stencil.offset, blocks, u + at, body_force, out + at, totals);
  }
  for (; at < length && at + lanes <= readable; at += lanes)
    accelerations_chunk<D, 1>(stencil.offset, blocks, u + at, body_force, out + at, totals);
  for (const Real& each : totals) total += each;
  return at < length ? at / D : length / D;
}

/// a = B u + g of the rows of some runs, and of the patches in them; false where one is not finite.
template <int D>
bool accelerations(const RowWeights& table, Runs runs, Runs patches, const double* u, Index size,
                   const double* body_force, double* to, Index out_base) {
  using Value = typename RowValue<D>::Type;
  constexpr int neighbours = D == 1 ? 2 : 8, mixing = D == 1 ? 0 : 4;  // of a node of a lattice
  const Real g = repeated<D>(body_force);
  const auto g_of_row = load<Value>(body_force);
  Real total{};
  Value rest{};
  const auto row_by_row = [&](const BlockStencil<D>& stencil, Index first, Index last) {
    for (Index row = first; row < last; ++row) {
      const Value a = acceleration_of_row<D>(stencil, u + row * D, g_of_row);
      rest += a;
      store(to + (row - out_base) * D, a);
    }
  };
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    const BlockStencil<D> stencil(table, run);
    Index done = 0;
    if (!sweep::row_by_row<D>(run)) {
      const double* from = u + static_cast<Index>(run.first) * D;
      double* out = to + (run.first - out_base) * D;
      const Index length = static_cast<Index>(run.count) * D;
      const Index reach = static_cast<Index>(table.reach[run.stencil]) * D;
      const Index readable = size - static_cast<Index>(run.first) * D - reach;
      const auto pass = [&](auto blocks) __attribute__((always_inline)) {
        done =
            accelerations_of_run<D>(stencil, blocks, from, length, readable, reach, g, out, total);
      };
      if (stencil.entries == neighbours && stencil.mixed == mixing)
        pass(KnownBlocks<D, neighbours, mixing>(stencil));
      else
        pass(AnyBlocks<D>(stencil));
    }
    row_by_row(stencil, run.first + done, run.first + run.count);
  }
  for (Index r = 0; r < patches.count; ++r) {
    const RowRun& run = patches.run[r];
    row_by_row(BlockStencil<D>(table, run), run.first, run.first + run.count);
  }
  // A sum is finite no more once an addend is not.
  double sum[D];
  std::memcpy(sum, &rest, sizeof sum);
  for (int i = 1; i < D; ++i) sum[0] += sum[i];
  for (int lane = 0; lane < TLSPH_LANES; ++lane) sum[0] += total[lane];
  return __builtin_isfinite(sum[0]) != 0;
}

/// The moves of the rows of some runs, whose accelerations are the rows of `motion`; the largest
/// |v|.
template <int D>
double move_on(Runs runs, const Motion& motion) {
  constexpr Index long_run = 8 * lanes;
  Real most{};
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    const double* a = motion.rows + (run.first - motion.rows_base) * D;
    const Index to = static_cast<Index>(run.first) * D;
    const Index length = static_cast<Index>(run.count) * D;
    Index at = 0;
    // Stores that cross no line cost half. Parts must round as vectors do, or results would depend
    // on where u stands: they do where they are one masked instruction.
    if (lanes == 8 && length >= long_run) {
      at = lanes - static_cast<Index>(
                       (reinterpret_cast<std::uintptr_t>(motion.u + to) / sizeof(double)) % lanes);
      move_part(load<Real>(a), at, motion, to, most);
    }
    for (; at + lanes <= length; at += lanes) {
      if constexpr (D > 1) fetch_to_write(motion.v + to + at);
      move_vector(load<Real>(a + at), motion, to + at, most);
    }
    if (at < length) move_part(load<Real>(a + at), length - at, motion, to + at, most);
  }
  double largest = 0.0;
  for (Index lane = 0; lane < lanes; ++lane) largest = most[lane] > largest ? most[lane] : largest;
  return largest;
}

}  // namespace
}  // namespace tlsph::sweep

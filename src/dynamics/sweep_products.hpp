#pragma once
/// \file
/// Products of stored rows with fields, vectorised across rows.
/// Local to each source that includes it, as everything here is (sweep_kernels_body.hpp).

#include "sweep_vectors.hpp"

namespace tlsph::sweep {
namespace {

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

/// Entries of general rows that are fetched before they are wanted: rows are short, and the
/// processor's own prefetching falls behind their sums.
constexpr Index ahead = 128;

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
      __builtin_prefetch(weights + (k + ahead) * Directions);
      add(k, 0);
      add(k + 1, 1);
    }
    if (k < end) add(k, 0);
    for (int a = 0; a < Directions; ++a)
      store(window.direction[a] + (row - window.base) * D, sum[0][a] + sum[1][a]);
  }
}

template <int D, int Directions>
void gradient_of_run(const Table& table, const RowRun& run, const double* u, Index size,
                     const Window& window) {
  if (run.stencil != no_stencil)
    gradient_stencil<D, Directions>(table, run, u, size, window);
  else if (table.weight_single != nullptr)
    gradient_general<D, Directions>(table, table.weight_single, run, u, window);
  else
    gradient_general<D, Directions>(table, table.weight, run, u, window);
}

template <int D, int Directions>
void gradient(const Table& table, Runs runs, const double* u, Index size, Window window) {
  for (Index r = 0; r < runs.count; ++r)
    gradient_of_run<D, Directions>(table, runs.run[r], u, size, window);
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
TLSPH_INLINE typename RowValue<D>::Type divergence_of_row(const Table& table, const Weight* weights,
                                                          Index row, const Window& P) {
  using Value = typename RowValue<D>::Type;
  Value sum[Directions] = {};
  for (Index k = table.row_start[row]; k < table.row_start[row + 1]; ++k) {
    __builtin_prefetch(weights + (k + ahead) * Directions);
    const Index from = (static_cast<Index>(table.column[k]) - P.base) * D;
    for (int a = 0; a < Directions; ++a)
      sum[a] +=
          static_cast<double>(weights[k * Directions + a]) * load<Value>(P.direction[a] + from);
  }
  Value total = sum[0];
  for (int a = 1; a < Directions; ++a) total += sum[a];
  if (table.row_scale != nullptr) total *= table.row_scale[row];
  return total;
}

template <int D, int Directions, class Weight>
TLSPH_INLINE void divergence_general(const Table& table, const Weight* weights, const RowRun& run,
                                     const Window& P, double* out, Index out_base) {
  for (Index row = run.first; row < run.first + run.count; ++row)
    store(out + (row - out_base) * D, divergence_of_row<D, Directions>(table, weights, row, P));
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

}  // namespace
}  // namespace tlsph::sweep

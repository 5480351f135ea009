#pragma once
/// \file
/// Products of stored rows with fields, vectorised across the rows of a stencil.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "rows.hpp"

namespace tlsph::sweep {
namespace {

/// The stencil of a run.
template <int Directions>
struct Stencil {
  const int* offset;
  const double* weight;
  int entries;

  Stencil(const RowWeights& table, const RowRun& run)
      : offset(table.offset + table.stencil_start[run.stencil]),
        weight(table.stencil_weight +
               static_cast<Index>(table.stencil_start[run.stencil]) * Directions),
        entries(table.stencil_start[run.stencil + 1] - table.stencil_start[run.stencil]) {}
};

/// A run from its row `done` on.
TLSPH_INLINE RowRun rest_of(RowRun run, Index done) {
  run.first += static_cast<int>(done);
  run.column += static_cast<int>(done);
  run.count -= static_cast<int>(done);
  return run;
}

/// w^a_k u[column_k] added to `sum[a]`, `Chunk` vectors of rows from `x` on. `Entries` of a
/// stencil, or as many as it has for 0.
template <int Directions, int Entries, int Chunk, class Weights>
TLSPH_INLINE void add_gradient(const int* offset, const Weights& weight, int entries, int D,
                               const double* x, Real (&sum)[Directions][Chunk]) {
  const int count = Entries > 0 ? Entries : entries;
  for (int k = 0; k < count; ++k) {
    const double* from = x + static_cast<Index>(offset[k]) * D;
    for (int c = 0; c < Chunk; ++c) {
      const Real value = load<Real>(from + c * lanes);
      for (int a = 0; a < Directions; ++a) sum[a][c] += weight[k * Directions + a] * value;
    }
  }
}

template <int D, int Directions>
void gradient(const RowWeights& table, Runs runs, const double* u, Index size, Window window) {
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    double* out[Directions];
    for (int a = 0; a < Directions; ++a)
      out[a] = window.direction[a] + (run.first - window.base) * D;
    Index done = 0;
    if (!row_by_row<D>(run)) {
      const Stencil<Directions> stencil(table, run);
      const double* x = u + static_cast<Index>(run.column) * D;
      const Index length = static_cast<Index>(run.count) * D;
      // The last vector may read beyond the run, not beyond the field.
      const Index readable = size - static_cast<Index>(run.column + table.reach[run.stencil]) * D;
      Index at = 0;
      const auto pass = [&](auto several) __attribute__((always_inline)) {
        constexpr int chunk = decltype(several)::value;
        Real sum[Directions][chunk] = {};
        add_gradient<Directions, 0>(stencil.offset, stencil.weight, stencil.entries, D, x + at,
                                    sum);
        for (int a = 0; a < Directions; ++a)
          for (int c = 0; c < chunk; ++c) store(out[a] + at + c * lanes, sum[a][c]);
        at += chunk * lanes;
      };
      while (at + 4 * lanes <= length) pass(Constant<4>{});
      while (at < length && at + lanes <= readable) pass(Constant<1>{});
      done = at < length ? at / D : run.count;
    }
    const RowRun rest = rest_of(run, done);
    for_each_row<Directions>(
        table, rest, [&](Index row, const auto& entries) __attribute__((always_inline)) {
          double* to[Directions];
          for (int a = 0; a < Directions; ++a)
            to[a] = window.direction[a] + (row - window.base) * D;
          gradient_of_row<D, Directions>(entries, u, to);
        });
  }
}

/// Σ_a Σ_k w^a_k P_a of `Chunk` vectors of rows, on top of what is in `sum`.
template <int Directions, int Entries, int Chunk, class Weights>
TLSPH_INLINE void add_divergence(const int* offset, const Weights& weight, int entries, int D,
                                 const double* const* P, Index at, Real (&sum)[Chunk]) {
  // As many sums as directions where vectors are few: they do not wait for each other.
  constexpr int parts = Chunk >= 4 ? 1 : Directions;
  Real part[parts][Chunk] = {};
  for (int c = 0; c < Chunk; ++c) part[0][c] = sum[c];
  const int count = Entries > 0 ? Entries : entries;
  for (int k = 0; k < count; ++k) {
    const Index from = static_cast<Index>(offset[k]) * D + at;
    for (int a = 0; a < Directions; ++a)
      for (int c = 0; c < Chunk; ++c)
        part[a % parts][c] += weight[k * Directions + a] * load<Real>(P[a] + from + c * lanes);
  }
  for (int c = 0; c < Chunk; ++c) {
    sum[c] = part[0][c];
    for (int p = 1; p < parts; ++p) sum[c] += part[p][c];
  }
}

template <int D, int Directions>
void divergence(const RowWeights& table, Runs runs, Window P, double* out, Index out_base) {
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    if (row_by_row<D>(run)) {
      for_each_row<Directions>(
          table, run, [&](Index row, const auto& entries) __attribute__((always_inline)) {
            store(out + (row - out_base) * D, divergence_of_row<D, Directions>(entries, P));
          });
      continue;
    }
    const Stencil<Directions> stencil(table, run);
    const double* from[Directions];
    for (int a = 0; a < Directions; ++a) from[a] = P.direction[a] + (run.column - P.base) * D;
    const Index length = static_cast<Index>(run.count) * D;
    Index at = 0;
    const auto pass = [&](auto several) __attribute__((always_inline)) {
      constexpr int chunk = decltype(several)::value;
      Real sum[chunk] = {};
      add_divergence<Directions, 0>(stencil.offset, stencil.weight, stencil.entries, D, from, at,
                                    sum);
      for (int c = 0; c < chunk; ++c)
        store(out + (run.first - out_base) * D + at + c * lanes, sum[c]);
      at += chunk * lanes;
    };
    while (at + 4 * lanes <= length) pass(Constant<4>{});
    while (at < length) pass(Constant<1>{});  // NOLINT(bugprone-infinite-loop): pass moves at
  }
}

template <int Chunk>
TLSPH_INLINE void differences_chunk(const Stencil<1>& stencil, int D, const double* x,
                                    const double* self, double* out) {
  Real centre[Chunk];
  Real sum[Chunk] = {};
  for (int c = 0; c < Chunk; ++c) centre[c] = load<Real>(self + c * lanes);
  for (int k = 0; k < stencil.entries; ++k)
    for (int c = 0; c < Chunk; ++c)
      sum[c] += stencil.weight[k] *
                (load<Real>(x + static_cast<Index>(stencil.offset[k]) * D + c * lanes) - centre[c]);
  for (int c = 0; c < Chunk; ++c) store(out + c * lanes, sum[c]);
}

template <int D>
void differences(const RowWeights& table, Runs runs, const double* x, Index size, double* to,
                 Index out_base) {
  using Value = typename RowValue<D>::Type;
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    Index done = 0;
    if (!row_by_row<D>(run)) {
      const Stencil<1> stencil(table, run);
      double* out = to + (run.first - out_base) * D;
      const double* from = x + static_cast<Index>(run.column) * D;
      const double* self = x + static_cast<Index>(run.first) * D;
      const Index length = static_cast<Index>(run.count) * D;
      const Index last_read = run.column + table.reach[run.stencil];
      const Index readable = size - (last_read > run.first ? last_read : run.first) * D;
      Index at = 0;
      for (; at + 4 * lanes <= length; at += 4 * lanes)
        differences_chunk<4>(stencil, D, from + at, self + at, out + at);
      for (; at < length && at + lanes <= readable; at += lanes)
        differences_chunk<1>(stencil, D, from + at, self + at, out + at);
      done = at < length ? at / D : run.count;
    }
    const RowRun rest = rest_of(run, done);
    for_each_row<1>(
        table, rest, [&](Index row, const auto& entries) __attribute__((always_inline)) {
          store(to + (row - out_base) * D,
                differences_of_row<D>(entries, x, load<Value>(x + row * D)));
        });
  }
}

}  // namespace
}  // namespace tlsph::sweep

#pragma once
/// \file
/// From places to stresses of material points, H never leaving registers where rows have a stencil.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "laws.hpp"
#include "products.hpp"

namespace tlsph::sweep {
namespace {

/// Strain and stress of the points of `Vectors` vectors, rows of one stencil. `Entries` of them, or
/// as many as it has for 0. Lanes of points from `rest` on are no points: they are left at rest.
template <int D, int Directions, int Entries, int Vectors, bool Full, class Law, class Weights>
TLSPH_INLINE void points_chunk(const Law& law, const int* offset, const Weights& weight,
                               int entries, const double* x, double* const* out, Index at,
                               Index rest, Whole& good) {
  const int count = Entries > 0 ? Entries : entries;
  const double* furthest = x + static_cast<Index>(offset[count - 1]) * D + at;
  for (int c = 0; c < Vectors * D; ++c) fetch_to_write(furthest + c * lanes);
  Real sum[Directions][Vectors * D] = {};
  add_gradient<Directions, Entries>(offset, weight, entries, D, x + at, sum);
  for (int p = 0; p < Vectors; ++p) {
    Real H[D][D];
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) H[a][c] = sum[a][p * D + c];
    if constexpr (!Full) {
      for (int c = 0; c < D; ++c) {
        Whole index;
        for (int lane = 0; lane < TLSPH_LANES; ++lane) index[lane] = c * TLSPH_LANES + lane;
        for (int a = 0; a < D; ++a) H[a][c] = index < rest * D ? H[a][c] : Real{};
      }
    }
    law_of<D>(law, H, good);
    for (int a = 0; a < D; ++a)
      for (int c = 0; c < D; ++c) store(out[a] + at + (p * D + c) * lanes, H[a][c]);
    for (int a = D; a < Directions; ++a)
      for (int c = 0; c < D; ++c) store(out[a] + at + (p * D + c) * lanes, sum[a][p * D + c]);
  }
}

/// The rows of a run whose vectors read no further than the field; how many they are.
template <int D, int Directions, int Entries, class Law>
TLSPH_INLINE Index points_stencil(const Law& law, const RowWeights& table, const RowRun& run,
                                  const double* u, Index size, const Window& window, Whole& good) {
  const Stencil<Directions> stencil(table, run);
  const double* x = u + static_cast<Index>(run.column) * D;
  double* out[Directions];
  for (int a = 0; a < Directions; ++a) out[a] = window.direction[a] + (run.first - window.base) * D;
  const Index length = static_cast<Index>(run.count) * D;
  // In doubles from the start of the run; the last vector may read beyond the run.
  const Index readable = size - static_cast<Index>(run.column + table.reach[run.stencil]) * D;
  constexpr Index step = lanes * D;
  Index at = 0;
  const auto pass = [&](const auto& weight, auto several) __attribute__((always_inline)) {
    constexpr int vectors = decltype(several)::value;
    for (; at + vectors * step <= length; at += vectors * step)
      points_chunk<D, Directions, Entries, vectors, true>(law, stencil.offset, weight,
                                                          stencil.entries, x, out, at, 0, good);
    if constexpr (vectors > 1)
      for (; at + step <= length; at += step)
        points_chunk<D, Directions, Entries, 1, true>(law, stencil.offset, weight, stencil.entries,
                                                      x, out, at, 0, good);
    if (at < length && at + step <= readable) {
      points_chunk<D, Directions, Entries, 1, false>(law, stencil.offset, weight, stencil.entries,
                                                     x, out, at, (length - at) / D, good);
      at = length;
    }
  };
  if constexpr (Entries > 0) {
    Real weight[Entries * Directions];
    for (int k = 0; k < Entries * Directions; ++k) weight[k] = all(stencil.weight[k]);
    pass(weight, Constant<3 - D>{});
  } else {
    pass(stencil.weight, Constant<4 / D>{});
  }
  return at / D;
}

/// H = G u and P of the rows of some runs, stabiliser rows beside them as one direction more. False
/// where a state has no stress.
template <int D, int Directions, class Law>
bool points(const void* of, const RowWeights& table, Runs runs, const double* u, Index size,
            Window out) {
  constexpr int corners = 1 << D;  // of a cell
  const Law law = as<Law>(of);
  Whole good = ~Whole{};
  bool rest_good = true;
  Index waiting = runs.count > 0 ? runs.run[0].first : 0;  // rows from there on have H, but no P
  const auto catch_up = [&](Index row) {
    if (row > waiting)
      rest_good =
          apply_law<D, Law>(of, out.direction, waiting - out.base, row - waiting) && rest_good;
  };
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    Index done = 0;
    if (!row_by_row<D>(run)) {
      catch_up(run.first);
      done = Stencil<Directions>(table, run).entries == corners
                 ? points_stencil<D, Directions, corners>(law, table, run, u, size, out, good)
                 : points_stencil<D, Directions, 0>(law, table, run, u, size, out, good);
      waiting = run.first + done;
    }
    if (done < run.count) {
      const RowRun rest = rest_of(run, done);
      gradient<D, Directions>(table, {&rest, 1}, u, size, out);
    }
  }
  if (runs.count > 0) catch_up(runs.run[runs.count - 1].first + runs.run[runs.count - 1].count);
  return everywhere(good) && rest_good;
}

}  // namespace
}  // namespace tlsph::sweep

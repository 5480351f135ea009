#pragma once
/// \file
/// Products of one row at a time: of rows without a stencil, and of runs too short for a vector.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "vectors.hpp"

namespace tlsph::sweep {
namespace {

/// Runs of which a vector would be mostly empty.
template <int D>
TLSPH_INLINE bool row_by_row(const RowRun& run) {
  return run.stencil == no_stencil || run.count * D * 2 < TLSPH_LANES;
}

/// act(row's number, its entries) for the rows of such a run.
template <int Directions, class Act>
TLSPH_INLINE void for_each_row(const RowWeights& table, const RowRun& run, const Act& act) {
  const Index end = run.first + run.count;
  if (run.stencil != no_stencil)
    for (Index row = run.first; row < end; ++row)
      act(row, stencil_row(table, Directions, run, row));
  else if (table.weight_single != nullptr)
    for (Index row = run.first; row < end; ++row)
      act(row, general_row(table, table.weight_single, Directions, row));
  else
    for (Index row = run.first; row < end; ++row)
      act(row, general_row(table, table.weight, Directions, row));
}

/// Entries whose weights are fetched before they are wanted: rows are short, and the processor's
/// own prefetching falls behind their sums.
constexpr Index ahead = 128;

/// Sums of a row that do not wait for each other: more of them where rows are long.
constexpr int few_entries = 8;

template <int D, int Directions, int Parts, class Weight>
TLSPH_INLINE void gradient_of_row(const Row<Weight>& row, const double* u,
                                  double* const (&out)[Directions]) {
  using Value = typename RowValue<D>::Type;
  // Single weights do not sum to zero; differences keep what a rigid motion must not make.
  constexpr bool differences_only = sizeof(Weight) < sizeof(double);
  const double* x = u + row.origin * D;
  Value reference{};
  if (differences_only && row.entries > 0)
    reference = load<Value>(x + static_cast<Index>(row.index[0]) * D);
  Value sum[Parts][Directions] = {};
  const auto add = [&](Index k, int part) __attribute__((always_inline)) {
    auto value = load<Value>(x + static_cast<Index>(row.index[k]) * D);
    if constexpr (differences_only) value -= reference;
    for (int a = 0; a < Directions; ++a)
      sum[part][a] += static_cast<double>(row.weight[k * Directions + a]) * value;
  };
  Index k = 0;
  for (; k + Parts <= row.entries; k += Parts) {
    __builtin_prefetch(row.weight + (k + ahead) * Directions);
    for (int part = 0; part < Parts; ++part) add(k + part, part);
  }
  for (int part = 0; part + 1 < Parts;
       ++part)  // its numbers must be known, or sums leave registers
    if (k + part < row.entries) add(k + part, part);
  for (int a = 0; a < Directions; ++a) {
    Value total = sum[0][a] + sum[1][a];
    if constexpr (Parts == 4) total += sum[2][a] + sum[3][a];
    store(out[a], total);
  }
}

/// out_a = Σ_k w^a_k u[column_k].
template <int D, int Directions, class Weight>
TLSPH_INLINE void gradient_of_row(const Row<Weight>& row, const double* u,
                                  double* const (&out)[Directions]) {
  if (row.entries <= few_entries)
    gradient_of_row<D, Directions, 2>(row, u, out);
  else
    gradient_of_row<D, Directions, 4>(row, u, out);
}

/// Σ_a Σ_k w^a_k P_a[column_k].
template <int D, int Directions, class Weight>
TLSPH_INLINE typename RowValue<D>::Type divergence_of_row(const Row<Weight>& row, const Window& P) {
  using Value = typename RowValue<D>::Type;
  const Index origin = row.origin - P.base;
  Value sum[2][Directions] = {};
  const auto add = [&](Index k, int part) __attribute__((always_inline)) {
    const Index from = (origin + row.index[k]) * D;
    for (int a = 0; a < Directions; ++a)
      sum[part][a] +=
          static_cast<double>(row.weight[k * Directions + a]) * load<Value>(P.direction[a] + from);
  };
  Index k = 0;
  for (; k + 2 <= row.entries; k += 2) {
    __builtin_prefetch(row.weight + (k + ahead) * Directions);
    add(k, 0);
    add(k + 1, 1);
  }
  if (k < row.entries) add(k, 0);
  Value total = sum[0][0] + sum[1][0];
  for (int a = 1; a < Directions; ++a) total += sum[0][a] + sum[1][a];
  return total * row.scale;
}

/// Σ_k w_k (x[column_k] − self).
template <int D, class Weight>
TLSPH_INLINE typename RowValue<D>::Type differences_of_row(const Row<Weight>& row,
                                                           const double* field,
                                                           typename RowValue<D>::Type self) {
  using Value = typename RowValue<D>::Type;
  const double* x = field + row.origin * D;
  constexpr int parts = 4;
  Value sum[parts] = {};
  const auto add = [&](Index k, int part) __attribute__((always_inline)) {
    sum[part] += static_cast<double>(row.weight[k]) *
                 (load<Value>(x + static_cast<Index>(row.index[k]) * D) - self);
  };
  Index k = 0;
  for (; k + parts <= row.entries; k += parts)
    for (int part = 0; part < parts; ++part) add(k + part, part);
  for (int part = 0; part + 1 < parts;
       ++part)  // its numbers must be known, or sums leave registers
    if (k + part < row.entries) add(k + part, part);
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) * row.scale;
}

}  // namespace
}  // namespace tlsph::sweep

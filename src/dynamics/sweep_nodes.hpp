#pragma once
/// \file
/// From stresses to new velocities and places of nodes, accelerations never leaving registers.
/// Local to each source that includes it, as everything here is (sweep_kernels_body.hpp).

#include "sweep_products.hpp"

namespace tlsph::sweep {
namespace {

/// v += kick a, u += dt v of `count` ≤ lanes doubles.
TLSPH_INLINE void move_part(Real a, Index count, const Motion& motion, Index at, Real& most) {
  double* v = motion.v + at;
  double* u = motion.u + at;
  const Real velocity = load_part(v, count) + motion.kick * a;
  store_part(v, count, velocity);
  store_part(u, count, load_part(u, count) + motion.dt * velocity);
  const Real speed = absolute(velocity);
  most = speed > most ? speed : most;
}

TLSPH_INLINE void move_vector(Real a, const Motion& motion, Index at, Real& most) {
  double* v = motion.v + at;
  double* u = motion.u + at;
  const Real velocity = load<Real>(v) + motion.kick * a;
  store(v, velocity);
  store(u, load<Real>(u) + motion.dt * velocity);
  const Real speed = absolute(velocity);
  most = speed > most ? speed : most;
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

template <int D, int Directions, int Entries, bool with_rows>
TLSPH_INLINE void move_stencil(const Table& table, const RowRun& run, const Window& window,
                               const Motion& motion, Real body_force, Real& most) {
  const int begin = table.stencil_start[run.stencil];
  const int entries = table.stencil_start[run.stencil + 1] - begin;
  const int* offset = table.offset + begin;
  const double* stored = table.stencil_weight + static_cast<Index>(begin) * Directions;
  const double* P[Directions];
  for (int a = 0; a < Directions; ++a) P[a] = window.direction[a] + (run.column - window.base) * D;
  const double* rows = with_rows ? motion.rows + (run.first - motion.rows_base) * D : nullptr;
  const Index to = static_cast<Index>(run.first) * D;
  const Index length = static_cast<Index>(run.count) * D;
  const auto accelerations = [&](const auto& weight, Index at, auto& a)
      __attribute__((always_inline)) {
    constexpr int chunk = static_cast<int>(sizeof a / sizeof(Real));
    for (int c = 0; c < chunk; ++c) {
      a[c] = body_force;
      if constexpr (with_rows) a[c] -= load<Real>(rows + at + c * lanes);
    }
    add_divergence<Directions, Entries>(offset, weight, entries, D, P, at, a);
  };
  const auto pass = [&](const auto& weight) __attribute__((always_inline)) {
    Index at = 0;
    for (; at + 4 * lanes <= length; at += 4 * lanes) {
      Real a[4];
      accelerations(weight, at, a);
      for (int c = 0; c < 4; ++c) {
        fetch_to_write(motion.v + to + at + c * lanes);
        move_vector(a[c], motion, to + at + c * lanes, most);
      }
    }
    for (; at < length; at += lanes) {
      Real a[1];
      accelerations(weight, at, a);
      if (at + lanes <= length)
        move_vector(a[0], motion, to + at, most);
      else
        move_part(a[0], length - at, motion, to + at, most);
    }
  };
  if constexpr (Entries > 0) {
    Real weight[Entries * Directions];
    for (int k = 0; k < Entries * Directions; ++k) weight[k] = all(stored[k]);
    pass(weight);
  } else {
    pass(stored);
  }
}

template <int D, int Directions, bool with_rows, class Weight>
TLSPH_INLINE void move_general(const Table& table, const Weight* weights, const RowRun& run,
                               const Window& P, const Motion& motion, Real body_force,
                               double& most) {
  using Value = typename RowValue<D>::Type;
  Value force;
  std::memcpy(&force, &body_force, sizeof force);
  for (Index row = run.first; row < run.first + run.count; ++row) {
    Value a = divergence_of_row<D, Directions>(table, weights, row, P) + force;
    if constexpr (with_rows) a -= load<Value>(motion.rows + (row - motion.rows_base) * D);
    const Value velocity = load<Value>(motion.v + row * D) + motion.kick * a;
    store(motion.v + row * D, velocity);
    store(motion.u + row * D, load<Value>(motion.u + row * D) + motion.dt * velocity);
    double component[D];
    std::memcpy(component, &velocity, sizeof component);
    for (const double c : component) {
      const double speed = c < 0.0 ? -c : c;
      most = speed > most ? speed : most;
    }
  }
}

template <int D, int Directions, bool with_rows>
double move_rows(const Table& table, Runs runs, Window P, const Motion& motion) {
  constexpr int corners = 1 << D;  // of a cell
  Real body_force;
  for (int lane = 0; lane < TLSPH_LANES; ++lane) body_force[lane] = motion.body_force[lane % D];
  Real most{};
  double largest = 0.0;
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    if (run.stencil == no_stencil) {
      if (table.weight_single != nullptr)
        move_general<D, Directions, with_rows>(table, table.weight_single, run, P, motion,
                                               body_force, largest);
      else
        move_general<D, Directions, with_rows>(table, table.weight, run, P, motion, body_force,
                                               largest);
      continue;
    }
    const int entries = table.stencil_start[run.stencil + 1] - table.stencil_start[run.stencil];
    if (entries == corners)
      move_stencil<D, Directions, corners, with_rows>(table, run, P, motion, body_force, most);
    else
      move_stencil<D, Directions, 0, with_rows>(table, run, P, motion, body_force, most);
  }
  for (Index lane = 0; lane < lanes; ++lane) largest = most[lane] > largest ? most[lane] : largest;
  return largest;
}

/// The new velocities and places of the rows of some runs; the largest |v|.
template <int D, int Directions>
double move(const Table& table, Runs runs, Window P, const Motion& motion) {
  return motion.rows != nullptr ? move_rows<D, Directions, true>(table, runs, P, motion)
                                : move_rows<D, Directions, false>(table, runs, P, motion);
}

}  // namespace
}  // namespace tlsph::sweep

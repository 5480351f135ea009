#pragma once
/// \file
/// From stresses to new velocities and places of nodes, accelerations never leaving registers.
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "products.hpp"

namespace tlsph::sweep {
namespace {

/// v += kick a, u += dt v of `count` ≤ lanes doubles; what stands in `a` beyond them is not used.
TLSPH_INLINE void move_part(Real a, Index count, const Motion& motion, Index at, Real& most) {
  double* v = motion.v + at;
  double* u = motion.u + at;
  const Real velocity = load_part(v, count) + motion.kick * part_of(a, count);
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

template <int D, int Directions, int Entries, bool WithRows>
TLSPH_INLINE void move_stencil(const RowWeights& table, const RowRun& run, const Window& window,
                               const Motion& motion, Real body_force, Real& most) {
  const Stencil<Directions> stencil(table, run);
  const double* P[Directions];
  for (int a = 0; a < Directions; ++a) P[a] = window.direction[a] + (run.column - window.base) * D;
  const double* rows = WithRows ? motion.rows + (run.first - motion.rows_base) * D : nullptr;
  const Index to = static_cast<Index>(run.first) * D;
  const Index length = static_cast<Index>(run.count) * D;
  const auto accelerations = [&](const auto& weight, Index at, auto& a)
      __attribute__((always_inline)) {
    constexpr int chunk = static_cast<int>(sizeof a / sizeof(Real));
    for (int c = 0; c < chunk; ++c) {
      a[c] = body_force;
      if constexpr (WithRows) a[c] -= load<Real>(rows + at + c * lanes);
    }
    add_divergence<Directions, Entries>(stencil.offset, weight, stencil.entries, D, P, at, a);
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
    for (int k = 0; k < Entries * Directions; ++k) weight[k] = all(stencil.weight[k]);
    pass(weight);
  } else {
    pass(stencil.weight);
  }
}

/// One row of whatever storage.
template <int D, int Directions, bool WithRows, class Weight>
TLSPH_INLINE void move_row(const Row<Weight>& entries, Index row, const Window& P,
                           const Motion& motion, Real body_force, double& most) {
  using Value = typename RowValue<D>::Type;
  Value a;
  std::memcpy(&a, &body_force, sizeof a);
  a += divergence_of_row<D, Directions>(entries, P);
  if constexpr (WithRows) a -= load<Value>(motion.rows + (row - motion.rows_base) * D);
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

template <int D, int Directions, bool WithRows>
double move_rows(const RowWeights& table, Runs runs, Window P, const Motion& motion) {
  constexpr int corners = 1 << D;  // of a cell
  Real body_force;
  for (int lane = 0; lane < TLSPH_LANES; ++lane) body_force[lane] = motion.body_force[lane % D];
  Real most{};
  double largest = 0.0;
  for (Index r = 0; r < runs.count; ++r) {
    const RowRun& run = runs.run[r];
    if (row_by_row<D>(run)) {
      for_each_row<Directions>(
          table, run, [&](Index row, const auto& entries) __attribute__((always_inline)) {
            move_row<D, Directions, WithRows>(entries, row, P, motion, body_force, largest);
          });
      continue;
    }
    if (Stencil<Directions>(table, run).entries == corners)
      move_stencil<D, Directions, corners, WithRows>(table, run, P, motion, body_force, most);
    else
      move_stencil<D, Directions, 0, WithRows>(table, run, P, motion, body_force, most);
  }
  for (Index lane = 0; lane < lanes; ++lane) largest = most[lane] > largest ? most[lane] : largest;
  return largest;
}

/// The new velocities and places of the rows of some runs; the largest |v|.
template <int D, int Directions>
double move(const RowWeights& table, Runs runs, Window P, const Motion& motion) {
  return motion.rows != nullptr ? move_rows<D, Directions, true>(table, runs, P, motion)
                                : move_rows<D, Directions, false>(table, runs, P, motion);
}

}  // namespace
}  // namespace tlsph::sweep

#pragma once
/// \file
/// Laws at blocks of material points: stresses in the place of strains, and how much points have
/// deformed since they were last looked at and how much stiffer that has made them, which the step
/// of a deforming body follows (tlsph/stepping/adaptive_step.hpp).
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "numbers.hpp"

namespace tlsph::sweep {
namespace {

// Points come in an order of their own, pairs of a lane's halves, which a pointwise law does not
// mind: no shuffle crosses them.
#if TLSPH_LANES == 8
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
#elif TLSPH_LANES == 4
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}
#else
TLSPH_INLINE Real evens(Real a, Real b) {
  return __builtin_shufflevector(a, b, 0, 2);
}
TLSPH_INLINE Real odds(Real a, Real b) {
  return __builtin_shufflevector(a, b, 1, 3);
}
#endif

/// Components by direction and interleaved, as vectors come from memory, to components (i, a) of a
/// vector of points, and back.
template <int D>
TLSPH_INLINE TensorOf<D, Real> components_of(const Real (&field)[D][D]) {
  TensorOf<D, Real> H;
  if constexpr (D == 1) {
    H(0, 0) = field[0][0];
  } else {
    for (int a = 0; a < D; ++a) {
      H(0, a) = evens(field[a][0], field[a][1]);
      H(1, a) = odds(field[a][0], field[a][1]);
    }
  }
  return H;
}
template <int D>
TLSPH_INLINE void interleave(const TensorOf<D, Real>& P, Real (&field)[D][D]) {
  if constexpr (D == 1) {
    field[0][0] = P(0, 0);
  } else {
    for (int a = 0; a < D; ++a) {
      field[a][0] = evens(P(0, a), P(1, a));
      field[a][1] = odds(P(0, a), P(1, a));
    }
  }
}

/// A vector of points in registers: H_a at `field[a]`, its components interleaved, becomes P_a.
template <int D, class Law>
TLSPH_INLINE void law_of(const Law& law, Real (&field)[D][D], Whole& good) {
  interleave<D>(law.stress(components_of<D>(field), good), field);
}

using Single = float __attribute__((vector_size(TLSPH_LANES * 4)));

/// A vector of which every lane is a point.
struct AllPoints {
  TLSPH_INLINE static Real load(const double* from, int) { return sweep::load<Real>(from); }
  TLSPH_INLINE static Real load(const float* from, int) {
    Single value{};
    std::memcpy(&value, from, sizeof value);
    return __builtin_convertvector(value, Real);
  }
  TLSPH_INLINE static void store(double* to, int, Real value) { sweep::store(to, value); }
};

/// One of which the first are, fewer than lanes; the others are at rest.
template <int D>
struct SomePoints {
  Index points;

  /// Numbers of the c-th of the D vectors that hold a direction.
  TLSPH_INLINE Index size(int c) const {
    const Index doubles = points * D - c * lanes;
    return doubles < 0 ? 0 : doubles < lanes ? doubles : lanes;
  }
  TLSPH_INLINE Real load(const double* from, int c) const { return load_part(from, size(c)); }
  TLSPH_INLINE Real load(const float* from, int c) const {
    Single value{};
    for (Index lane = 0; lane < size(c); ++lane) value[lane] = from[lane];
    return __builtin_convertvector(value, Real);
  }
  TLSPH_INLINE void store(double* to, int c, Real value) const { store_part(to, size(c), value); }
};

template <int D, class Points, class Number>
TLSPH_INLINE TensorOf<D, Real> read(const Points& points, Number* const* from, Index at) {
  Real value[D][D];
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) value[a][c] = points.load(from[a] + at * D + c * lanes, c);
  return components_of<D>(value);
}
template <int D, class Points>
TLSPH_INLINE void write(const Points& points, double* const* to, Index at,
                        const TensorOf<D, Real>& P) {
  Real value[D][D];
  interleave<D>(P, value);
  for (int a = 0; a < D; ++a)
    for (int c = 0; c < D; ++c) points.store(to[a] + at * D + c * lanes, c, value[a][c]);
}

/// Calls visit(points, at) for the vectors of `count` points.
template <int D, class Visit>
TLSPH_INLINE void for_vectors(Index count, const Visit& visit) {
  Index at = 0;
  for (; at + lanes <= count; at += lanes) visit(AllPoints(), at);
  if (at < count) visit(SomePoints<D>{count - at}, at);
}

template <class Law>
TLSPH_INLINE const Law& as(const void* law) {
  return *static_cast<const Law*>(law);
}

template <int D, class Law>
bool apply_law(const void* of, double* const* field, Index first, Index count) {
  const Law law = as<Law>(of);
  Whole good = ~Whole{};
  for_vectors<D>(
      count, [&](const auto& points, Index at) __attribute__((always_inline)) {
        write<D>(points, field, first + at, law.stress(read<D>(points, field, first + at), good));
      });
  return everywhere(good);
}

/// dP = A : dH, with A the law's tangent at H.
template <int D, class Law>
void apply_tangent(const void* of, const double* const* H, const double* const* dH,
                   double* const* dP, Index count) {
  const Law law = as<Law>(of);
  for_vectors<D>(
      count, [&](const auto& points, Index at) __attribute__((always_inline)) {
        write<D>(points, dP, at,
                 action_of<D>(law, read<D>(points, H, at), read<D>(points, dH, at)));
      });
}

/// The larger of the two in each lane; what is not a number is left out.
TLSPH_INLINE Real larger(Real value, Real most) {
  return value > most ? value : most;
}
TLSPH_INLINE double largest_lane(Real value) {
  double most = 0.0;
  for (Index lane = 0; lane < lanes; ++lane) most = value[lane] > most ? value[lane] : most;
  return most;
}

/// max ‖H − H₀‖² ‖F⁻¹‖² of `count` points.
template <int D>
double deformation(const double* const* H, const float* const* before, Index count) {
  Real most{};
  for_vectors<D>(
      count, [&](const auto& points, Index at) __attribute__((always_inline)) {
        const TensorOf<D, Real> now = read<D>(points, H, at);
        const TensorOf<D, Real> then = read<D>(points, before, at);
        const TensorOf<D, Real> F = deformation_gradient<D>(now);
        const Real J = 1.0 + volume_change<D>(now);
        Real change{}, cofactors{};
        const TensorOf<D, Real> cof = cofactor<D>(F);
        for (int i = 0; i < D; ++i)
          for (int a = 0; a < D; ++a) {
            const Real difference = now(i, a) - then(i, a);
            change += difference * difference;
            cofactors += cof(i, a) * cof(i, a);
          }
        most = larger(change * cofactors / (J * J), most);
      });
  return largest_lane(most);
}

/// max λ_max(A(H) − A(H₀)) of `count` points, at most that: no eigenvalue lies right of
/// Gershgorin's discs.
template <int D, class Law>
double stiffening(const void* of, const double* const* H, const float* const* before, Index count) {
  constexpr int size = D * D;
  const Law law = as<Law>(of);
  Real most{};
  for_vectors<D>(
      count, [&](const auto& points, Index at) __attribute__((always_inline)) {
        const TensorOf<size, Real> A = tangent_of<D>(law, read<D>(points, H, at));
        const TensorOf<size, Real> B = tangent_of<D>(law, read<D>(points, before, at));
        Real body[size];
        for (int row = 0; row < size; ++row) body[row] = A(row, row) - B(row, row);
        for (int row = 0; row < size; ++row)
          for (int column = row + 1; column < size; ++column) {
            const Real radius = absolute(A(row, column) - B(row, column));
            body[row] += radius;
            body[column] += radius;
          }
        for (const Real& right : body) most = larger(right, most);
      });
  return largest_lane(most);
}

}  // namespace
}  // namespace tlsph::sweep

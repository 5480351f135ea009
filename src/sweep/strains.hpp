#pragma once
/// \file
/// How much points have deformed since they were last looked at, and how much stiffer that has made
/// them: what the step of a deforming body follows (tlsph/stepping/adaptive_step.hpp).
/// Local to each source that includes it, as everything here is (loops_body.hpp).

#include "laws.hpp"

namespace tlsph::sweep {
namespace {

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
        Real disc[size];
        for (int row = 0; row < size; ++row) disc[row] = A(row, row) - B(row, row);
        for (int row = 0; row < size; ++row)
          for (int column = row + 1; column < size; ++column) {
            const Real radius = absolute(A(row, column) - B(row, column));
            disc[row] += radius;
            disc[column] += radius;
          }
        for (const Real& right : disc) most = larger(right, most);
      });
  return largest_lane(most);
}

}  // namespace
}  // namespace tlsph::sweep

#pragma once
/// \file
/// Kinematics in terms of the displacement gradient H, F = I + H, written so that nothing cancels
/// when H is tiny: J − 1 is never formed as a difference.

#include <cmath>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// F = I + H.
template <int D>
[[nodiscard]] Tensor<D> deformation_gradient(const Tensor<D>& H) {
  return Tensor<D>::Identity() + H;
}

/// cof A, so that A⁻ᵀ = cof A / det A.
template <int D>
[[nodiscard]] Tensor<D> cofactor(const Tensor<D>& A) {
  Tensor<D> cof;
  if constexpr (D == 1) {
    cof(0, 0) = 1.0;
  } else if constexpr (D == 2) {
    cof << A(1, 1), -A(1, 0), -A(0, 1), A(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 3; ++a) {
        const int j = (i + 1) % 3, k = (i + 2) % 3, b = (a + 1) % 3, c = (a + 2) % 3;
        cof(i, a) = A(j, b) * A(k, c) - A(j, c) * A(k, b);
      }
  }
  return cof;
}

/// J − 1 − tr H: the part of the volume change that is not linear in H.
template <int D>
[[nodiscard]] double nonlinear_volume_change(const Tensor<D>& H) {
  if constexpr (D == 1)
    return 0.0;
  else if constexpr (D == 2)
    return H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
  else
    return cofactor<3>(H).trace() + H.row(0).dot(cofactor<3>(H).row(0));
}

/// J − 1 = tr H + …, exact for small H.
template <int D>
[[nodiscard]] double volume_change(const Tensor<D>& H) {
  return H.trace() + nonlinear_volume_change<D>(H);
}

/// F − cof F = H + Hᵀ − tr(H) I (− cof H in 3D), free of cancellation.
template <int D>
[[nodiscard]] Tensor<D> deformation_minus_cofactor(const Tensor<D>& H) {
  if constexpr (D == 1)
    return H;
  else if constexpr (D == 2) {
    const double shear = H(0, 1) + H(1, 0);
    const double stretch = H(0, 0) - H(1, 1);
    Tensor<2> difference;
    difference << stretch, shear, shear, -stretch;
    return difference;
  } else {
    return H + H.transpose() - H.trace() * Tensor<3>::Identity() - cofactor<3>(H);
  }
}

/// Green–Lagrange strain E = (H + Hᵀ + HᵀH)/2.
template <int D>
[[nodiscard]] Tensor<D> green_lagrange(const Tensor<D>& H) {
  return 0.5 * (H + H.transpose() + H.transpose() * H);
}

/// ln J from e = J − 1 to full relative precision, NaN for J ≤ 0. The rounding error of 1 + e is
/// known exactly and put back; cheaper than log1p, and the division by J is one the caller needs
/// anyway.
[[nodiscard]] inline double log_volume(double e) {
  const double J = 1 + e;
  return std::log(J) + (e - (J - 1)) / J;
}

/// ln(1 + x) − x without cancellation; the leading term is −x²/2. Uses ln(1 + x) = 2 artanh s with
/// s = x/(2 + x) and 2s − x = −s x.
[[nodiscard]] inline double log1p_minus(double x) {
  if (!(std::abs(x) < 0.25)) return log_volume(x) - x;
  const double s = x / (2 + x);
  const double square = s * s;
  double series = 0.0;
  for (int k = 21; k >= 3; k -= 2) series = square * (series + 1.0 / k);
  return s * (2 * series - x);
}

}  // namespace tlsph

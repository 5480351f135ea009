#pragma once
/// \file
/// Kinematics in terms of the displacement gradient H, F = I + H, written so that nothing cancels
/// when H is tiny: J − 1 is never formed as a difference. M is a Tensor<D> or a TensorOf<D, R>.

#include "tlsph/materials/numbers.hpp"

namespace tlsph {

/// F = I + H.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline M deformation_gradient(const M& H) {
  M F = H;
  for (int i = 0; i < D; ++i) F(i, i) = 1.0 + H(i, i);
  return F;
}

/// cof A, so that A⁻ᵀ = cof A / det A.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline M cofactor(const M& A) {
  M cof;
  if constexpr (D == 1) {
    cof(0, 0) = Numbers<NumberOf<M>>::all(1.0);
  } else if constexpr (D == 2) {
    cof(0, 0) = A(1, 1);
    cof(0, 1) = -A(1, 0);
    cof(1, 0) = -A(0, 1);
    cof(1, 1) = A(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 3; ++a) {
        const int j = (i + 1) % 3, k = (i + 2) % 3, b = (a + 1) % 3, c = (a + 2) % 3;
        cof(i, a) = A(j, b) * A(k, c) - A(j, c) * A(k, b);
      }
  }
  return cof;
}

template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline NumberOf<M> trace(const M& H) {
  NumberOf<M> sum = H(0, 0);
  for (int i = 1; i < D; ++i) sum = sum + H(i, i);
  return sum;
}

/// J − 1 − tr H: the part of the volume change that is not linear in H.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline NumberOf<M> nonlinear_volume_change(const M& H) {
  if constexpr (D == 2) {
    return H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
  } else if constexpr (D == 3) {
    const M cof = cofactor<3>(H);
    return trace<3>(cof) + (H(0, 0) * cof(0, 0) + H(0, 1) * cof(0, 1) + H(0, 2) * cof(0, 2));
  } else {
    return Numbers<NumberOf<M>>::all(0.0);
  }
}

/// J − 1 = tr H + …, exact for small H.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline NumberOf<M> volume_change(const M& H) {
  if constexpr (D == 1)
    return H(0, 0);
  else
    return trace<D>(H) + nonlinear_volume_change<D>(H);
}

/// F − cof F = H + Hᵀ − tr(H) I (− cof H in 3D), free of cancellation.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline M deformation_minus_cofactor(const M& H) {
  M difference = H;
  if constexpr (D == 2) {
    difference(0, 0) = H(0, 0) - H(1, 1);
    difference(0, 1) = difference(1, 0) = H(0, 1) + H(1, 0);
    difference(1, 1) = -difference(0, 0);
  } else if constexpr (D == 3) {
    const M cof = cofactor<3>(H);
    for (int i = 0; i < 3; ++i)
      for (int a = 0; a < 3; ++a) difference(i, a) = H(i, a) + H(a, i) - cof(i, a);
    for (int i = 0; i < 3; ++i) difference(i, i) = difference(i, i) - trace<3>(H);
  }
  return difference;
}

/// Green–Lagrange strain E = (H + Hᵀ + HᵀH)/2.
template <int D, class M>
[[nodiscard]] [[gnu::always_inline]] inline M green_lagrange(const M& H) {
  M E;
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) {
      NumberOf<M> product = H(0, a) * H(0, b);
      for (int i = 1; i < D; ++i) product = product + H(i, a) * H(i, b);
      if (a == b)
        E(a, a) = H(a, a) + 0.5 * product;
      else
        E(a, b) = E(b, a) = 0.5 * (H(a, b) + H(b, a) + product);
    }
  return E;
}

}  // namespace tlsph

#pragma once
/// \file
/// How much points have deformed since they were last looked at, and how much stiffer that has made
/// them: what the step of a deforming body follows (tlsph/dynamics/step_follower.hpp).
/// Local to each source that includes it, as everything here is (sweep_kernels_body.hpp).

#include "sweep_laws.hpp"

namespace tlsph::sweep {
namespace {

/// The displacement gradients of a vector of points, component by component: h[i][a].
template <int D>
struct Gradients {
  Real h[D][D];
};

template <int D, class Load>
TLSPH_INLINE Gradients<D> gradients_of(const Load& value) {
  Gradients<D> result;
  if constexpr (D == 1) {
    result.h[0][0] = value(0, 0);
  } else {
    for (int a = 0; a < D; ++a) {
      const Real low = value(a, 0), high = value(a, 1);
      result.h[0][a] = evens(low, high);
      result.h[1][a] = odds(low, high);
    }
  }
  return result;
}

/// The first `count` ≤ lanes numbers, others zero.
TLSPH_INLINE Real load_single(const float* from, Index count) {
  using Single = float __attribute__((vector_size(TLSPH_LANES * 4)));
  Single value{};
  if (count == lanes)
    std::memcpy(&value, from, sizeof value);
  else
    for (Index lane = 0; lane < count; ++lane) value[lane] = from[lane];
  return __builtin_convertvector(value, Real);
}

/// Calls visit(now, before) for the points of a block, a vector at a time; lanes beyond the last
/// point are at rest.
template <int D, class Visit>
TLSPH_INLINE void for_pairs(const double* const* H, const float* const* before, Index count,
                            const Visit& visit) {
  Index at = 0;
  for (; at + lanes <= count; at += lanes)
    visit(gradients_of<D>([&](int a, int c) __attribute__((always_inline)) {
            return load<Real>(H[a] + at * D + c * lanes);
          }),
          gradients_of<D>([&](int a, int c) __attribute__((always_inline)) {
            return load_single(before[a] + at * D + c * lanes, lanes);
          }));
  if (at == count) return;
  const auto part = [&](int c) {
    const Index doubles = (count - at) * D - c * lanes;
    return doubles < 0 ? 0 : doubles < lanes ? doubles : lanes;
  };
  visit(gradients_of<D>([&](int a, int c) __attribute__((always_inline)) {
          return load_part(H[a] + at * D + c * lanes, part(c));
        }),
        gradients_of<D>([&](int a, int c) __attribute__((always_inline)) {
          return load_single(before[a] + at * D + c * lanes, part(c));
        }));
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
  for_pairs<D>(
      H, before,
      count, [&](const Gradients<D>& now, const Gradients<D>& then) __attribute__((always_inline)) {
        const Real e00 = now.h[0][0] - then.h[0][0];
        const Real f00 = 1.0 + now.h[0][0];
        if constexpr (D == 1) {
          most = larger(e00 * e00 / (f00 * f00), most);
        } else {
          const Real e01 = now.h[0][1] - then.h[0][1];
          const Real e10 = now.h[1][0] - then.h[1][0];
          const Real e11 = now.h[1][1] - then.h[1][1];
          const Real f01 = now.h[0][1], f10 = now.h[1][0];
          const Real f11 = 1.0 + now.h[1][1];
          const Real J = f00 * f11 - f01 * f10;
          const Real change = e00 * e00 + e01 * e01 + (e10 * e10 + e11 * e11);
          const Real cofactor = f00 * f00 + f01 * f01 + (f10 * f10 + f11 * f11);
          most = larger(change * cofactor / (J * J), most);
        }
      });
  return largest_lane(most);
}

/// The upper triangle of ∂P/∂F by rows, components in the order 00, 01, 10, 11.
template <int D>
struct Tangent {
  static constexpr int entries = D == 1 ? 1 : 10;
  Real entry[entries];
};

template <int D>
TLSPH_INLINE Tangent<D> tangent_of(const LinearElastic& law, const Gradients<D>&) {
  Tangent<D> A{};
  if constexpr (D == 1) {
    A.entry[0] = law.lambda + 2.0 * law.mu;
  } else {
    A.entry[0] = A.entry[9] = law.lambda + 2.0 * law.mu;
    A.entry[3] = law.lambda;
    A.entry[4] = A.entry[5] = A.entry[7] = law.mu;
  }
  return A;
}

/// δ_ij S_ab + λ F_ia F_jb + μ (δ_ab (F Fᵀ)_ij + F_ib F_ja).
template <int D, bool Free>
TLSPH_INLINE Tangent<D> tangent_of(const StVenantKirchhoff<Free>& law, const Gradients<D>& H) {
  Tangent<D> A;
  const Real h00 = H.h[0][0];
  if constexpr (D == 1) {
    const Real f = 1.0 + h00;
    A.entry[0] = (law.lambda + 2.0 * law.mu) * (h00 + 0.5 * h00 * h00 + f * f);
  } else {
    const Real h01 = H.h[0][1], h10 = H.h[1][0], h11 = H.h[1][1];
    const Real f00 = 1.0 + h00, f11 = 1.0 + h11;
    const Real e00 = h00 + 0.5 * (h00 * h00 + h10 * h10);
    const Real e11 = h11 + 0.5 * (h01 * h01 + h11 * h11);
    const Real pressure = law.lambda * (e00 + e11);
    const Real s00 = pressure + 2.0 * law.mu * e00;
    const Real s11 = pressure + 2.0 * law.mu * e11;
    const Real s01 = law.mu * (h01 + h10 + (h00 * h01 + h10 * h11));
    const Real both = law.lambda + law.mu;
    const Real b00 = law.mu * (f00 * f00 + h01 * h01);
    const Real b01 = law.mu * (f00 * h10 + h01 * f11);
    const Real b11 = law.mu * (h10 * h10 + f11 * f11);
    A.entry[0] = s00 + both * f00 * f00 + b00;
    A.entry[1] = s01 + both * f00 * h01;
    A.entry[2] = b01 + both * f00 * h10;
    A.entry[3] = law.lambda * f00 * f11 + law.mu * h01 * h10;
    A.entry[4] = s11 + both * h01 * h01 + b00;
    A.entry[5] = law.lambda * h01 * h10 + law.mu * f00 * f11;
    A.entry[6] = b01 + both * h01 * f11;
    A.entry[7] = s00 + both * h10 * h10 + b11;
    A.entry[8] = s01 + both * h10 * f11;
    A.entry[9] = s11 + both * f11 * f11 + b11;
  }
  return A;
}

/// μ dH − (μ − p)/J cof dH + (μ − p + p')/J² (c : dH) c with c = cof F, as in
/// materials/neo_hookean.hpp; in 1D μ + (μ − p + p')/J².
template <int D, int Free>
TLSPH_INLINE Tangent<D> tangent_of(const NeoHookean<Free>& law, const Gradients<D>& H) {
  Tangent<D> A;
  Whole good{};
  Real inverse;
  if constexpr (D == 1) {
    const Real h = H.h[0][0];
    const Real log = log_and_inverse(h, 1.0 + h, inverse, good);
    const Real pressure = law.pressure(log, good);
    A.entry[0] = law.mu + (law.mu - pressure + law.stiffness(pressure)) * inverse * inverse;
  } else {
    const Real h00 = H.h[0][0], h01 = H.h[0][1], h10 = H.h[1][0], h11 = H.h[1][1];
    const Real e = h00 + h11 + (h00 * h11 - h01 * h10);
    const Real log = log_and_inverse(e, 1.0 + e, inverse, good);
    const Real pressure = law.pressure(log, good);
    const Real turned = (law.mu - pressure) * inverse;
    const Real along = (law.mu - pressure + law.stiffness(pressure)) * inverse * inverse;
    const Real c00 = 1.0 + h11, c11 = 1.0 + h00;
    const Real a00 = along * c00, a01 = -(along * h10), a10 = -(along * h01), a11 = along * c11;
    A.entry[0] = law.mu + a00 * c00;
    A.entry[1] = -(a00 * h10);
    A.entry[2] = -(a00 * h01);
    A.entry[3] = a00 * c11 - turned;
    A.entry[4] = law.mu - a01 * h10;
    A.entry[5] = turned - a01 * h01;
    A.entry[6] = a01 * c11;
    A.entry[7] = law.mu - a10 * h01;
    A.entry[8] = a10 * c11;
    A.entry[9] = law.mu + a11 * c11;
  }
  return A;
}

/// max λ_max(A(H) − A(H₀)) of `count` points, at most that: no eigenvalue lies right of
/// Gershgorin's discs.
template <int D, class Law>
double stiffening(const LawConstants& constants, const double* const* H, const float* const* before,
                  Index count) {
  const Law law{all(constants.lambda), all(constants.mu)};
  Real most{};
  for_pairs<D>(
      H, before,
      count, [&](const Gradients<D>& now, const Gradients<D>& then) __attribute__((always_inline)) {
        const Tangent<D> A = tangent_of(law, now);
        const Tangent<D> B = tangent_of(law, then);
        Real d[Tangent<D>::entries], size[Tangent<D>::entries];
        for (int k = 0; k < Tangent<D>::entries; ++k) {
          d[k] = A.entry[k] - B.entry[k];
          size[k] = absolute(d[k]);
        }
        if constexpr (D == 1) {
          most = larger(d[0], most);
        } else {
          most = larger(d[0] + size[1] + (size[2] + size[3]), most);
          most = larger(d[4] + size[1] + (size[5] + size[6]), most);
          most = larger(d[7] + size[2] + (size[5] + size[8]), most);
          most = larger(d[9] + size[3] + (size[6] + size[8]), most);
        }
      });
  return largest_lane(most);
}

}  // namespace
}  // namespace tlsph::sweep

#pragma once
/// \file
/// Plane waves on an unbounded lattice. The linear forces of such a body are one stencil repeated,
/// so a wave u e^{ik·X} is answered by its Fourier symbol, a d×d matrix:
///
///     ω² u = D(k) u,    D(k) = Σ_q K_q cos k·d_q
///
/// with d_q the offsets of the neighbours and K_q the blocks of M⁻¹K; the sines cancel, for every
/// offset has its mirror image.

#include <array>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

template <int D>
struct LatticeSymbol {
  std::vector<Vector<D>> offset;  ///< d_q [m]
  std::vector<Tensor<D>>
      block;  ///< K_q [1/s²]: row the component of the answer, column of the push

  /// D(k) [1/s²], k [1/m]; symmetric.
  [[nodiscard]] Tensor<D> at(const Vector<D>& k) const;
};

/// The waves of one k: ω² [1/s²], the transverse one first (there is none in 1D), told apart by
/// which eigenvector lies nearer to k. Negative where the wave grows.
template <int D>
[[nodiscard]] std::array<double, D> squared_frequencies(const LatticeSymbol<D>& symbol,
                                                        const Vector<D>& k);

/// How the waves travel: their phase speeds over the exact ones c = (transverse, longitudinal), or
/// c_p alone in 1D [m/s], k running over directions and wave numbers.
template <int D>
struct PhaseSpeeds {
  std::vector<Vector<D>> k;                     ///< kΔ
  std::vector<std::array<double, D>> relative;  ///< ω/(c|k|), zero where ω² < 0
};
/// Wave numbers |k|Δ = π n/`radial`, n = 1…`radial`, in `angular` + 1 directions from the first
/// axis to the second.
template <int D>
[[nodiscard]] PhaseSpeeds<D> phase_speeds(const LatticeSymbol<D>& symbol, double spacing,
                                          const std::array<double, D>& exact, int radial,
                                          int angular);

/// Waves that cost less than `nothing` times (c_p/Δ)² at the corners of the Brillouin zone, (π, 0),
/// (0, π) and (π, π) over Δ, or π/Δ in 1D; each counts for its directions of motion.
template <int D>
[[nodiscard]] int zero_energy_waves(const LatticeSymbol<D>& symbol, const Vector<D>& spacings,
                                    double fastest, double nothing = 1e-10);

}  // namespace tlsph

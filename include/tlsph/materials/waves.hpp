#pragma once
/// \file
/// Elastic waves: moduli, speeds, and whether a deformed state still carries them.

#include "tlsph/materials/lame.hpp"
#include "tlsph/materials/law.hpp"

namespace tlsph {

/// Modulus [Pa] of the longitudinal plane wave in the undeformed body: λ + 2μ in strain (and 3D),
/// E/(1−ν²) in plane stress, E in 1D stress. Throws InputError as `lame`.
[[nodiscard]] double p_modulus(int dimension, Assumption assumption, double young, double poisson);

/// √(modulus/density) [m/s]: with the modulus above the longitudinal, with μ the shear wave.
[[nodiscard]] double wave_speed(double modulus, double density);

/// The smallest eigenvalue [Pa] of the acoustic tensors Q_ij(N) = A_iajb N_a N_b over all
/// directions N: ρc² of the slowest plane wave. In 2D the angle is scanned and the best one
/// refined. D is 1 or 2.
template <int D>
[[nodiscard]] double smallest_acoustic_eigenvalue(const Tangent<D>& A);

/// Whether every plane wave has a real speed. Where this fails the homogeneous state cannot exist.
/// Much cheaper than the eigenvalue wherever the answer is yes.
template <int D>
[[nodiscard]] bool is_hyperbolic(const Tangent<D>& A);

}  // namespace tlsph

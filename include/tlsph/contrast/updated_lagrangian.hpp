#pragma once
/// \file
/// A counter-example, not a method of this project: SPH in the *current* configuration, the form
/// most codes have. Neighbours and kernel sums are built anew every step, so the kernel moves with
/// the particles, and a body in tension comes apart into clumps:
///
///     dv_i/dt = Σ_j m_j (σ_i/ρ_i² + σ_j/ρ_j²) ∇_i W_ij
///     L_i     = Σ_j (m_j/ρ_j) (v_j − v_i) ⊗ ∇_i W_ij = d + w
///     dρ/dt   = −ρ tr L          dσ/dt = λ tr(d) I + 2μ d + wσ − σw
///
/// without correction at boundaries and without viscosity, as in the stability studies of Swegle et
/// al. (J. Comput. Phys. 116, 1995); contrast/growth.hpp says how fast it must fail. Only the cases
/// and the atlas that show the failure may include this room.

#include "tlsph/core/types.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/materials/lame.hpp"

namespace tlsph {

/// What does not change. Hypoelastic with Jaumann rate; a fluid of bulk modulus λ where μ = 0.
template <int D>
struct CurrentBody {
  AnyKernel kernel;
  double h = 0.0;         ///< full support radius, of all particles and at all times [m]
  Lame moduli;            ///< [Pa], as the D directions see them
  ScalarField mass;       ///< N [kg]
  VectorField<D> motion;  ///< N×d: 1 where a particle is free, 0 where it is held
};

/// What does. All fields in the current configuration.
template <int D>
struct CurrentState {
  double time = 0.0;      ///< t_n [s]
  VectorField<D> x;       ///< positions at t_n, N×d [m]
  VectorField<D> v;       ///< velocities at t_{n−½}, N×d [m/s]
  ScalarField density;    ///< N [kg/m³]
  TensorField<D> stress;  ///< Cauchy stress, N×d² [Pa]
};

/// dv/dt of every particle, held ones included, N×d [m/s²].
template <int D>
[[nodiscard]] VectorField<D> acceleration(const CurrentBody<D>& body, const CurrentState<D>& state);

/// One step [s] of the central difference, v before x; density and stress follow v_{n+½} with the
/// kernels at t_n. NumericalError where a density or a velocity is no longer a positive or finite
/// number.
template <int D>
void advance(const CurrentBody<D>& body, CurrentState<D>& state, double dt);

/// ½ Σ m |v|² at t_{n−½} [J per thickness].
template <int D>
[[nodiscard]] double kinetic_energy(const CurrentBody<D>& body, const CurrentState<D>& state);

}  // namespace tlsph

#pragma once
/// \file
/// How fast the sums of contrast/updated_lagrangian.hpp fail: the symbol of the linearised sum over
/// an unbounded lattice under the uniform stress σ₀ I. With d the offsets of the neighbours,
///
///     C(k) = V Σ_d (1 − cos k·d) ∇∇W(d)        g(k) = V Σ_d sin(k·d) ∇W(d)
///     ω² ↔ −[ (2σ₀/ρ) C − (1/ρ) ((λ + 2σ₀) g gᵀ + μ (|g|² I + g gᵀ)) ]
///
/// the first term being how the moving kernel turns the stress, the second the stiffness as the
/// sums see it. At the shortest wave g vanishes and growth at √(2σ₀ C/ρ) is left: the tensile
/// instability. A run of a finite lattice shows the same rate.

#include <array>
#include <functional>
#include <vector>

#include "tlsph/contrast/updated_lagrangian.hpp"

namespace tlsph {

/// A lattice of spacing Δ in D directions under σ₀ I.
template <int D>
struct StressedLattice {
  AnyKernel kernel;
  double h = 0.0;        ///< full support radius [m]
  double spacing = 0.0;  ///< Δ [m]
  Lame moduli;           ///< [Pa], as the D directions see them
  double density = 0.0;  ///< [kg/m³]
  double stress = 0.0;   ///< σ₀ [Pa], tension positive
};

/// d²u/dt² = symbol · u for displacements u e^{ik·X} [1/s²]; `k` [1/m].
template <int D>
[[nodiscard]] Tensor<D> symbol(const StressedLattice<D>& lattice, const Vector<D>& k);

/// Largest growth rate √(eigenvalue of the symbol) [1/s] of the wave k; zero where it is stable.
template <int D>
[[nodiscard]] double growth_rate(const StressedLattice<D>& lattice, const Vector<D>& k);

/// The wave that grows fastest, by a scan of [0, π/Δ]^d in 64 intervals a direction.
template <int D>
struct GrowingWave {
  Vector<D> k = Vector<D>::Zero();  ///< [1/m]
  double rate = 0.0;                ///< [1/s]
};
template <int D>
[[nodiscard]] GrowingWave<D> fastest_growth(const StressedLattice<D>& lattice);

/// A lattice of finite size, to be stepped.
template <int D>
struct CurrentRun {
  CurrentBody<D> body;
  CurrentState<D> state;
};

/// `counts` particles a direction, the last coordinate fastest, at rest; `held` layers at each end
/// of each direction do not move.
template <int D>
[[nodiscard]] CurrentRun<D> current_lattice(const StressedLattice<D>& lattice,
                                            const std::array<int, D>& counts, int held);

/// Moves the particles by `displacement` [m] without motion: stress and density follow as in a
/// step.
template <int D>
void displace(CurrentRun<D>& run, const VectorField<D>& displacement);

/// The kinetic energy over the first, after each step.
struct EnergyHistory {
  std::vector<double> time, energy;
};

/// Steps of `dt` until `end` [s], or until the body is lost; `observe` sees each state.
template <int D>
EnergyHistory step_until(CurrentRun<D>& run, double dt, double end,
                         const std::function<void(const CurrentState<D>&)>& observe = {});

/// Largest growth rate [1/s] of small motions of that very body, its held layers included: √ of the
/// rightmost eigenvalue of the derivative of its accelerations, which is symmetric for equal
/// masses.
template <int D>
[[nodiscard]] double linear_growth_rate(const CurrentRun<D>& run);

}  // namespace tlsph

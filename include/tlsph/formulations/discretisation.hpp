#pragma once
/// \file
/// A formulation is nothing but a choice of operators and of how prescribed values enter them:
///
///     H = G u (+ signals)      P = ∂Ψ/∂F at F = I + H      a = M⁻¹ (D P − S u − C v + f(t))
///
/// A Discretisation holds that choice. It is const once built; State is the only thing that
/// changes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tlsph/formulations/conditions.hpp"
#include "tlsph/formulations/ghosts.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/operators/consistency.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Material points of one law.
template <int D>
struct Region {
  AnyLaw<D> law;
  double density = 0.0;     ///< [kg/m³]
  std::vector<int> points;  ///< ascending; empty: all of the body

  /// How many it has in a body of so many, and the k-th of them.
  [[nodiscard]] Index size(Index all) const {
    return points.empty() ? all : static_cast<Index>(points.size());
  }
  [[nodiscard]] Index point(Index k) const {
    return points.empty() ? k : Index{points[static_cast<std::size_t>(k)]};
  }
};

template <int D>
struct Discretisation {
  Particles<D> particles;
  MaterialPoints<D> points;
  double spacing = 0.0;  ///< Δ [m]

  VectorOperator<D> gradient;                       ///< G, M×N [1/m]
  VectorOperator<D> divergence;                     ///< D, N×M [m^(d−1)]
  bool adjoint = true;                              ///< D = −Gᵀ V_s
  std::optional<ConsistencyResiduals> consistency;  ///< of a corrected gradient
  /// S, N×N [N/m per thickness], same for all components; 0×0 if off, or held as `hourglass`
  /// (dynamics/stabiliser_forces.hpp knows both).
  SparseMatrix stiffness;
  HourglassModes hourglass;                        ///< the cell stabiliser as stiffness, or empty
  SparseMatrix viscosity;                          ///< C, N×N [kg/s], 0×0 if off
  std::shared_ptr<const GhostGradient<D>> ghosts;  ///< replaces G in the `thesis` formulation

  ScalarField mass;                ///< N [kg]
  VectorField<D> inverse_mass;     ///< N×d, zero at constrained degrees of freedom
  std::vector<Region<D>> regions;  ///< every point in exactly one

  Constraints constraints;
  std::vector<ReactionTerm> reactions;  ///< of all constraints if D is no adjoint, else empty
  std::vector<Load> loads;
  Vector<D> body_force = Vector<D>::Zero();  ///< acceleration [m/s²]

  std::vector<Signal> signals;
  std::vector<SignalTerm> gradient_terms;  ///< added to H
  std::vector<SignalTerm> force_terms;     ///< added to D P
  std::vector<SignalTerm> stress_values;   ///< P at these slots is weight · signal

  [[nodiscard]] Index nodes() const { return particles.size(); }
  [[nodiscard]] bool has_body_force() const { return body_force.squaredNorm() > 0.0; }
  /// True when no law tells the deformed body from the reference configuration.
  [[nodiscard]] bool small_strain() const;
  /// Numbers that a material point remembers, the most of any law.
  [[nodiscard]] int memory() const;
  /// True when every law is linear, so that the critical step holds for ever.
  [[nodiscard]] bool linear() const { return small_strain() && memory() == 0; }
  /// Largest longitudinal wave speed of the undeformed body, c_p [m/s].
  [[nodiscard]] double wave_speed() const;
};

}  // namespace tlsph

#pragma once
/// \file
/// What the world does to the body: degrees of freedom that are held or moved, loads, and the
/// signals (a number a time) that enter the operators of formulations with ghosts. Degrees of
/// freedom are numbered node·d + component.

#include <vector>

#include "tlsph/curves/curve.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Prescribed displacements: zero for `fixed`, that of t = 0 for `held`, curve value [m] for
/// `moved`.
struct Constraints {
  struct Motion {
    Index dof = 0;
    std::size_t curve = 0;
  };
  std::vector<Index> fixed;   ///< sorted, each once
  std::vector<Index> held;    ///< sorted, disjoint from `fixed`
  std::vector<Motion> moved;  ///< sorted, disjoint from both
  std::vector<Curve> curves;
};

/// f[dof] += weight · curve(t), weights [m^(d−1)] for a curve in Pa.
struct Load {
  Curve curve;
  std::vector<Index> dof;
  std::vector<double> weight;
};

/// Where forces are no adjoint of the strains, the force of a support on the body is not what a
/// node lacks to its acceleration but the stress on the boundary: reaction[dof] += weight ·
/// P[slot], slot = node·d² + component, weights [m^(d−1)].
struct ReactionTerm {
  Index dof = 0;
  Index slot = 0;
  double weight = 0.0;
};
/// Component i of ∫ P N dA over a patch.
template <int D>
[[nodiscard]] std::vector<ReactionTerm> reaction_terms(const Patch<D>& patch, int i);

/// Load of a traction along the outward normal, tension positive.
template <int D>
[[nodiscard]] Load normal_traction(const Patch<D>& patch, const Curve& curve);
/// Load of one component of a traction vector per reference area.
template <int D>
[[nodiscard]] Load component_traction(const Patch<D>& patch, int component, const Curve& curve);

/// A scalar that boundary conditions feed into the operators each step.
struct Signal {
  enum class Kind {
    value,              ///< the curve itself
    uniaxial_gradient,  ///< the H_11 at which P_11 equals the curve, P⁻¹(t̄)
  };
  Curve curve;
  Kind kind = Kind::value;
  std::size_t region = 0;  ///< whose law P⁻¹ belongs to
};

/// entry `slot` of a field += weight · signal.
struct SignalTerm {
  Index slot = 0;
  std::size_t signal = 0;
  double weight = 0.0;
};

}  // namespace tlsph

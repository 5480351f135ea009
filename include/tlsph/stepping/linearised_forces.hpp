#pragma once
/// \file
/// The forces of a run linearised at a state: K = −∂f/∂u with the tangents of the law there, at its
/// memory, by the run's own operators. `product` serves Lanczos (critical_step.hpp);
/// `dynamical_matrix` gives the full matrix of a small body.

#include <optional>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/sweep/stiffness_product.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

template <int D>
class LinearisedForces {
 public:
  /// Both must outlive this, and H and memory of the state must stay as they are. A sweep of the
  /// same discretisation, which must outlive this too, lends its operators.
  LinearisedForces(const Discretisation<D>& discretisation, const State<D>& state,
                   const Sweep<D>* sweep = nullptr);
  /// With the unit tangent in place of the laws', and without stabiliser.
  explicit LinearisedForces(const Discretisation<D>& discretisation,
                            const Sweep<D>* sweep = nullptr);
  LinearisedForces(const LinearisedForces&) = delete;
  LinearisedForces& operator=(const LinearisedForces&) = delete;

  /// −K x = D (A : G x) − S x, the change of the forces with a displacement x (N×d) [N per
  /// thickness]. Signals do not change.
  void product(const VectorField<D>& x, VectorField<D>& force);

  /// M^-½ K M^-½ over the free degrees of freedom, ascending [1/s²], column by column, n² time;
  /// exactly symmetric where D is the adjoint of G.
  [[nodiscard]] SparseMatrix dynamical_matrix();

  /// M^-½ C M^-½ in the same order [1/s]; empty without viscosity.
  [[nodiscard]] SparseMatrix damping_matrix() const;

 private:
  void prepare();
  void apply_tangents();

  const Discretisation<D>& body_;
  const State<D>* state_ = nullptr;  // none: the unit tangent
  TensorField<D> H_;
  std::optional<Sweep<D>> sweep_;               // of large undeformed bodies, a tenth of the cost
  std::optional<StiffnessProduct<D>> tangent_;  // of large deformed ones, a quarter of it
  State<D> moved_;
  std::vector<double> zero_;
  typename GhostGradient<D>::Workspace workspace_;
};

}  // namespace tlsph

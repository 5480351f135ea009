#pragma once
/// \file
/// Products K x with the tangent stiffness of a deformed body, by the operators and inner loops of
/// a sweep: the change of the strains and at once, in its place, of the stresses, then the forces.

#include <memory>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

template <int D>
class StiffnessProduct {
 public:
  /// At `state`; both must outlive this and `state.H` stay as it is. `Sweep::possible`, no
  /// viscosity. `sweep` of the same discretisation, which must outlive this too, lends its
  /// operators; nullptr: they are stored anew.
  StiffnessProduct(const Discretisation<D>& discretisation, const State<D>& state,
                   const Sweep<D>* sweep = nullptr);
  /// With the unit tangent in place of the laws', and without stabiliser.
  StiffnessProduct(const Discretisation<D>& discretisation, const Sweep<D>& sweep);
  StiffnessProduct(StiffnessProduct&&) noexcept;
  ~StiffnessProduct();

  /// −K x = D (A : G x) − S x, the change of the forces with a displacement x (N×d) [N per
  /// thickness].
  void product(const VectorField<D>& x, VectorField<D>& force);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tlsph

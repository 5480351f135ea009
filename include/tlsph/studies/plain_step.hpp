#pragma once
/// \file
/// The plain way to make a step: one sparse product of Eigen for every direction and component, a
/// pointwise law, an update. What a sweep is measured against.

#include <vector>

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

template <int D>
class PlainStep {
 public:
  /// Of a free body of one law.
  explicit PlainStep(const Discretisation<D>& discretisation, const VectorField<D>& u);
  void step(double dt);
  [[nodiscard]] const Eigen::VectorXd& displacement(int component) const {
    return u_[at(component)];
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  const Discretisation<D>& disc_;
  std::vector<SparseMatrix> gradient_, divergence_;  // a direction each
  SparseMatrix stabiliser_;                          // as stiffness, multiplied out
  std::vector<Eigen::VectorXd> u_, v_, f_;           // a component each
  std::vector<Eigen::VectorXd> H_, P_;               // component i and direction a at i*D + a
};

}  // namespace tlsph

#pragma once
/// \file
/// The plain way to make a step: one sparse product of Eigen for every direction and component, a
/// pointwise law, an update. What a sweep is measured against.

#include <variant>
#include <vector>

#include "tlsph/dynamics/stabiliser_forces.hpp"
#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

template <int D>
class PlainStep {
 public:
  /// Of a free body of one law.
  PlainStep(const Discretisation<D>& body, const VectorField<D>& u)
      : body_(body), stabiliser_(stabiliser_matrix<D>(body)), u_(u) {
    for (int a = 0; a < D; ++a) {
      gradient_.push_back(body.gradient.matrix(a));
      divergence_.push_back(body.divergence.matrix(a));
    }
    v_ = f_ = Columns<D>::Zero(u.rows(), D);
    H_ = P_ = Columns<D * D>::Zero(body.points.size(), D * D);
  }

  void step(double dt) {
    for (int c = 0; c < D * D; ++c)
      H_.col(c).noalias() = gradient_[static_cast<std::size_t>(c % D)] * u_.col(c / D);
    std::visit(
        [&](const auto& law) {
          for (Index s = 0; s < body_.points.size(); ++s) {
            Tensor<D> H;
            for (int c = 0; c < D * D; ++c) H.data()[c] = H_(s, c);
            const Tensor<D> P = law.pk1(H);
            for (int c = 0; c < D * D; ++c) P_(s, c) = P.data()[c];
          }
        },
        body_.regions.front().law);
    for (int i = 0; i < D; ++i) {
      f_.col(i).noalias() = divergence_[0] * P_.col(i * D);
      for (int a = 1; a < D; ++a)
        f_.col(i).noalias() += divergence_[static_cast<std::size_t>(a)] * P_.col(i * D + a);
      if (stabiliser_.nonZeros() > 0) f_.col(i).noalias() -= stabiliser_ * u_.col(i);
      for (Index q = 0; q < body_.nodes(); ++q) {
        v_(q, i) += dt * body_.inverse_mass(q, i) * f_(q, i);
        u_(q, i) += dt * v_(q, i);
      }
    }
  }

 private:
  /// Each column in one piece of memory.
  template <int N>
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, N>;

  const Discretisation<D>& body_;
  std::vector<SparseMatrix> gradient_, divergence_;  // a direction each
  SparseMatrix stabiliser_;                          // as stiffness, multiplied out
  Columns<D> u_, v_, f_;
  Columns<D * D> H_, P_;  // component i and direction a at i*D + a
};

}  // namespace tlsph

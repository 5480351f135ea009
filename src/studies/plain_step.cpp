#include "tlsph/studies/plain_step.hpp"

#include <variant>

#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph {

template <int D>
PlainStep<D>::PlainStep(const Discretisation<D>& disc, const VectorField<D>& u)
    : disc_(disc), stabiliser_(stabiliser_matrix<D>(disc)) {
  for (int a = 0; a < D; ++a) {
    gradient_.push_back(disc.gradient.matrix(a));
    divergence_.push_back(disc.divergence.matrix(a));
    u_.emplace_back(u.col(a));
    v_.emplace_back(Eigen::VectorXd::Zero(u.rows()));
    f_.emplace_back(Eigen::VectorXd::Zero(u.rows()));
  }
  H_.assign(D * D, Eigen::VectorXd::Zero(disc.points.size()));
  P_ = H_;
}

template <int D>
void PlainStep<D>::step(double dt) {
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a) H_[at(i * D + a)].noalias() = gradient_[at(a)] * u_[at(i)];
  std::visit(
      [&](const auto& law) {
        for (Index s = 0; s < disc_.points.size(); ++s) {
          Tensor<D> H;
          for (int c = 0; c < D * D; ++c) H.data()[c] = H_[at(c)][s];
          const Tensor<D> P = law.pk1(H);
          for (int c = 0; c < D * D; ++c) P_[at(c)][s] = P.data()[c];
        }
      },
      disc_.regions.front().law);
  for (int i = 0; i < D; ++i) {
    Eigen::VectorXd& f = f_[at(i)];
    f.noalias() = divergence_[0] * P_[at(i * D)];
    for (int a = 1; a < D; ++a) f.noalias() += divergence_[at(a)] * P_[at(i * D + a)];
    if (stabiliser_.nonZeros() > 0) f.noalias() -= stabiliser_ * u_[at(i)];
    for (Index q = 0; q < disc_.nodes(); ++q) {
      v_[at(i)][q] += dt * disc_.inverse_mass(q, i) * f[q];
      u_[at(i)][q] += dt * v_[at(i)][q];
    }
  }
}

template class PlainStep<1>;
template class PlainStep<2>;

}  // namespace tlsph

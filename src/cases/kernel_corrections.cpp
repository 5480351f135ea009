#include "kernel_corrections.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tlsph/operators/gradients.hpp"

namespace tlsph {
namespace {

/// W and ∇W times volumes, on one pattern.
struct Sums {
  SparseMatrix W;
  PlainGradient dW;

  Sums(const AnyKernel& kernel, double h, const Particles<2>& particles)
      : W(kernel_matrix<2>(kernel, h, particles.X, particles.V)) {
    const auto plain = plain_gradient<2>(kernel, h, particles.X, particles.V);
    dW = {plain.matrix(0), plain.matrix(1)};
  }
};

/// Calls entry(k, b, V W, V ∇W) for the neighbours b of particle a, k their place in the arrays.
template <class Entry>
void for_neighbours(const Sums& sums, Index a, const Entry& entry) {
  for (Index k = sums.W.outerIndexPtr()[a]; k < sums.W.outerIndexPtr()[a + 1]; ++k)
    entry(k, Index{sums.W.innerIndexPtr()[k]}, sums.W.valuePtr()[k],
          Vector<2>{sums.dW[0].valuePtr()[k], sums.dW[1].valuePtr()[k]});
}

void store(PlainGradient& G, Index k, const Vector<2>& value) {
  G[0].valuePtr()[k] = value[0];
  G[1].valuePtr()[k] = value[1];
}

}  // namespace

PlainGradient shepard_gradient(const AnyKernel& kernel, double h, const Particles<2>& particles,
                               Gamma gamma_times) {
  const Sums sums(kernel, h, particles);
  PlainGradient G = sums.dW;
  for (Index a = 0; a < particles.size(); ++a) {
    double sum = 0.0;
    Vector<2> gamma = Vector<2>::Zero();
    for_neighbours(sums, a, [&](Index, Index, double w, const Vector<2>& dw) {
      sum += w;
      gamma += dw;
    });
    gamma /= sum;
    for_neighbours(sums, a, [&](Index k, Index b, double w, const Vector<2>& dw) {
      store(G, k, (dw - gamma * (gamma_times == Gamma::kernel ? w : particles.V[b])) / sum);
    });
  }
  return G;
}

LinearKernel linear_kernel(const AnyKernel& kernel, double h, const Particles<2>& particles) {
  const Sums sums(kernel, h, particles);
  LinearKernel result{sums.W, sums.dW};
  for (Index a = 0; a < particles.size(); ++a) {
    // W̃_b = W_b p·c with p = (1, x − x_b), M c = (1, 0, 0), M = Σ V W p pᵀ; so α = c₀, β = c₁₂/c₀,
    // and ∂c = −M⁻¹ ∂M c.
    const auto basis = [&](Index b) {
      const Vector<2> d = (particles.X.row(a) - particles.X.row(b)).transpose();
      return Eigen::Vector3d(1.0, d[0], d[1]);
    };
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    std::array<Eigen::Matrix3d, 2> dM = {M, M};
    for_neighbours(sums, a, [&](Index, Index b, double w, const Vector<2>& dw) {
      const Eigen::Vector3d p = basis(b);
      M += w * p * p.transpose();
      for (int i = 0; i < 2; ++i) {
        const Eigen::Vector3d dp = Eigen::Vector3d::Unit(i + 1);
        dM[static_cast<std::size_t>(i)] +=
            dw[i] * p * p.transpose() + w * (dp * p.transpose() + p * dp.transpose());
      }
    });
    const Eigen::Matrix3d inverse = M.inverse();
    const Eigen::Vector3d c = inverse.col(0);
    const std::array<Eigen::Vector3d, 2> dc = {-inverse * dM[0] * c, -inverse * dM[1] * c};
    for_neighbours(sums, a, [&](Index k, Index b, double w, const Vector<2>& dw) {
      const Eigen::Vector3d p = basis(b);
      result.value.valuePtr()[k] = w * p.dot(c);
      store(result.gradient, k,
            dw * p.dot(c) + w * (Vector<2>{c[1], c[2]} + Vector<2>{p.dot(dc[0]), p.dot(dc[1])}));
    });
  }
  return result;
}

double constant_residual(const PlainGradient& G, const Particles<2>& particles) {
  const ScalarField one = ScalarField::Ones(particles.size());
  return particles.spacing *
         std::max((G[0] * one).cwiseAbs().maxCoeff(), (G[1] * one).cwiseAbs().maxCoeff());
}

ScalarField linear_residual(const PlainGradient& G, const Particles<2>& particles) {
  ScalarField worst = ScalarField::Zero(particles.size());
  for (std::size_t direction = 0; direction < 2; ++direction)
    for (Index a = 0; a < particles.size(); ++a) {
      Vector<2> sum = -Vector<2>::Unit(static_cast<Index>(direction));
      for (SparseMatrix::InnerIterator it(G[direction], a); it; ++it)
        sum += it.value() * (particles.X.row(it.col()) - particles.X.row(a)).transpose();
      worst[a] = std::max(worst[a], sum.cwiseAbs().maxCoeff());
    }
  return worst;
}

}  // namespace tlsph

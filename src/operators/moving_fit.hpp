#pragma once
/// \file
/// Moving least squares at one point.

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "tlsph/kernels/families.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {

/// Whether the moment matrix of a linear fit, whose entries are of the size `scale`, has an
/// inverse.
template <int D>
inline bool is_regular(const Tensor<D>& moment, double scale, double least) {
  return std::abs(moment.determinant()) > least * std::pow(scale, D);
}

/// The derivatives of polynomials fitted to the nodes around a point by moving least squares.
template <int D, class Family>
class MovingFit {
 public:
  MovingFit(const Family& family, const VectorField<D>& points, const VectorField<D>& X, int order)
      : family_(family), points_(points), X_(X), degree_(order), exponents_(monomials<D>(order)) {}

  [[nodiscard]] int degree() const { return degree_; }

  /// The weights of the first derivatives at point s, D for each of the nodes within h. False where
  /// the nodes do not determine the polynomial: a reciprocal condition below `least`.
  bool weights(Index s, std::span<const int> nodes, double h, double least, double* weights) const {
    return degree_ > 1 ? quadratic(s, nodes, h, least, weights)
                       : linear(s, nodes, h, least, weights);
  }

 private:
  [[nodiscard]] Vector<D> arm(Index s, int q) const {
    return (X_.row(q) - points_.row(s)).transpose();
  }

  /// c·p(X_q − X_s), p the monomials in units of h: rows 1 … D of M⁻¹ Σ w p, M = Σ w p pᵀ.
  bool quadratic(Index s, std::span<const int> nodes, double h, double least,
                 double* weights) const {
    constexpr int terms = (D + 1) * (D + 2) / 2;
    using Moment = Eigen::Matrix<double, terms, terms>;
    const auto values = [&](int q) -> Eigen::Matrix<double, terms, 1> {
      return monomial_values<D>(exponents_, Vector<D>(arm(s, q) / h));
    };
    Moment moment = Moment::Zero();
    for (const int q : nodes) {
      const auto p = values(q);
      moment += kernel_value<D>(family_, arm(s, q).norm(), h) * p * p.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Moment> spectrum(moment);
    if (!(spectrum.eigenvalues()[0] > least * spectrum.eigenvalues()[terms - 1])) return false;
    const Eigen::Matrix<double, D, terms> inverse =
        moment.ldlt().solve(Moment::Identity()).template middleRows<D>(1) / h;
    for (const int q : nodes) {
      const double w = kernel_value<D>(family_, arm(s, q).norm(), h);
      const Vector<D> weight = w * (inverse * values(q));
      weights = std::copy_n(weight.data(), D, weights);
    }
    return true;
  }

  /// Centred on the weighted mean, the fit of c + g·(X − X̄) decouples: g = M⁻¹ Σ w (X − X̄) f.
  bool linear(Index s, std::span<const int> nodes, double h, double least, double* weights) const {
    double sum = 0.0;
    Vector<D> mean = Vector<D>::Zero();
    for (const int q : nodes) {
      const double w = kernel_value<D>(family_, arm(s, q).norm(), h);
      sum += w;
      mean += w * arm(s, q);
    }
    mean /= sum;
    Tensor<D> moment = Tensor<D>::Zero();
    for (const int q : nodes) {
      const double w = kernel_value<D>(family_, arm(s, q).norm(), h) / sum;
      const Vector<D> off = arm(s, q) - mean;
      moment += w * off * off.transpose();
    }
    if (!is_regular<D>(moment, h * h, least)) return false;
    const Tensor<D> inverse = moment.inverse();
    for (const int q : nodes) {
      const double w = kernel_value<D>(family_, arm(s, q).norm(), h) / sum;
      const Vector<D> weight = w * inverse * (arm(s, q) - mean);
      weights = std::copy_n(weight.data(), D, weights);
    }
    return true;
  }

  const Family& family_;
  const VectorField<D>& points_;
  const VectorField<D>& X_;
  int degree_;
  std::vector<std::array<int, D>> exponents_;
};

}  // namespace tlsph

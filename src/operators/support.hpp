#pragma once
/// \file
/// The nodes around a point, as fits and kernel sums over them see them.

#include <Eigen/LU>
#include <cmath>
#include <span>
#include <vector>

#include "tlsph/kernels/families.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {

/// Whether the moment matrix of a linear fit, whose entries are of the size `scale`, has an
/// inverse.
template <int D>
bool is_regular(const Tensor<D>& moment, double scale, double least) {
  return std::abs(moment.determinant()) > least * std::pow(scale, D);
}

template <int D>
struct Support {
  /// Of a polynomial of degree two.
  static constexpr int terms = (D + 1) * (D + 2) / 2;
  using Polynomial = Eigen::Matrix<double, terms, 1>;
  using Moment = Eigen::Matrix<double, terms, terms>;

  const AnyKernel& kernel;
  double h;                    ///< support radius of the kernel [m]
  std::span<const int> nodes;  ///< ascending
  std::vector<Vector<D>> arm;  ///< X_q − X_s
  Eigen::VectorXd value;       ///< W(|X_q − X_s|)

  Support(const AnyKernel& family, double radius, const Vector<D>& at, std::span<const int> near,
          const VectorField<D>& X)
      : kernel(family), h(radius), nodes(near), arm(near.size()), value(size()) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      arm[k] = X.row(nodes[k]).transpose() - at;
      value[static_cast<Index>(k)] = kernel_value<D>(kernel, arm[k].norm(), h);
    }
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(nodes.size()); }

  /// dW/dr / r of its k-th node; zero for the point itself.
  [[nodiscard]] double pull(std::size_t k) const {
    const double r = arm[k].norm();
    return r == 0.0 ? 0.0 : kernel_first<D>(kernel, r, h) / r;
  }
  /// ∇_s W(X_s − X_q). Where the two share a coordinate X_s − X_q is +0, the negative arm −0.
  [[nodiscard]] Vector<D> slope(std::size_t k) const {
    return pull(k) * (Vector<D>::Zero() - arm[k]);
  }

  /// Σ V ∇W ⊗ (X_q − X_s) of slopes ∇W.
  [[nodiscard]] Tensor<D> moment(const std::vector<Vector<D>>& slopes, const ScalarField& V) const {
    Tensor<D> sum = Tensor<D>::Zero();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      sum += V[nodes[k]] * slopes[k] * arm[k].transpose();
    return sum;
  }

  /// The weights V L ∇W in place of slopes ∇W.
  void weigh(std::vector<Vector<D>>& slopes, const Tensor<D>& L, const ScalarField& V) const {
    for (std::size_t k = 0; k < nodes.size(); ++k) slopes[k] = (V[nodes[k]] * L * slopes[k]).eval();
  }

  /// Gives the node `self` minus the sum of the other weights; returns the sum of their lengths.
  double close(std::vector<Vector<D>>& weights, Index self) const {
    Vector<D> others = Vector<D>::Zero();
    double size = 0.0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (nodes[k] == self) continue;
      others += weights[k];
      size += weights[k].norm();
    }
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (nodes[k] == self) weights[k] = -others;
    return size + others.norm();
  }

  /// The monomials up to degree two of arm/unit, a column for each node.
  [[nodiscard]] Eigen::Matrix<double, terms, Eigen::Dynamic> quadratics(double unit) const {
    static const auto exponents = monomials<D>(2);
    Eigen::Matrix<double, terms, Eigen::Dynamic> values(terms, size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      values.col(static_cast<Index>(k)) = monomial_values<D>(exponents, Vector<D>(arm[k] / unit));
    return values;
  }
};

}  // namespace tlsph

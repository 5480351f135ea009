#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>
#include <utility>

#include "support.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/operators/gradients.hpp"

namespace tlsph {
namespace {

/// Reciprocal condition below which a moment matrix counts as singular, and the one that a row
/// whose radius is chosen here should have.
constexpr double singular = 1e-10, well_conditioned = 1e-7;
/// A row that its nodes do not determine takes those of a radius larger by this ratio, and again,
/// up to so many times the support.
constexpr double ratio = 1.1, widest = 2.5;

// Moving least squares: the weights of the first derivatives of a fitted polynomial, D for each
// node. False where the nodes do not determine it: a reciprocal condition below `least`.

/// c·p(X_q − X_s), p the monomials in units of h: rows 1 … D of M⁻¹ Σ w p, M = Σ w p pᵀ.
template <int D>
bool fit_quadratic(const Support<D>& support, double least, double* weights) {
  using Moment = typename Support<D>::Moment;
  const auto values = support.quadratics(support.h);
  Moment moment = Moment::Zero();
  for (Index k = 0; k < support.size(); ++k) {
    const typename Support<D>::Polynomial p = values.col(k);
    moment += support.value[k] * p * p.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Moment> spectrum(moment);
  if (!(spectrum.eigenvalues()[0] > least * spectrum.eigenvalues()[Support<D>::terms - 1]))
    return false;
  const Eigen::Matrix<double, D, Support<D>::terms> inverse =
      moment.ldlt().solve(Moment::Identity()).template middleRows<D>(1) / support.h;
  for (Index k = 0; k < support.size(); ++k) {
    const typename Support<D>::Polynomial p = values.col(k);
    const Vector<D> weight = support.value[k] * (inverse * p);
    weights = std::copy_n(weight.data(), D, weights);
  }
  return true;
}

/// Centred on the weighted mean, the fit of c + g·(X − X̄) decouples: g = M⁻¹ Σ w (X − X̄) f.
template <int D>
bool fit_linear(const Support<D>& support, double least, double* weights) {
  double sum = 0.0;
  Vector<D> mean = Vector<D>::Zero();
  for (std::size_t k = 0; k < support.arm.size(); ++k) {
    const double w = support.value[static_cast<Index>(k)];
    sum += w;
    mean += w * support.arm[k];
  }
  mean /= sum;
  Tensor<D> moment = Tensor<D>::Zero();
  for (std::size_t k = 0; k < support.arm.size(); ++k) {
    const double w = support.value[static_cast<Index>(k)] / sum;
    const Vector<D> off = support.arm[k] - mean;
    moment += w * off * off.transpose();
  }
  if (!is_regular<D>(moment, support.h * support.h, least)) return false;
  const Tensor<D> inverse = moment.inverse();
  for (std::size_t k = 0; k < support.arm.size(); ++k) {
    const double w = support.value[static_cast<Index>(k)] / sum;
    const Vector<D> weight = w * inverse * (support.arm[k] - mean);
    weights = std::copy_n(weight.data(), D, weights);
  }
  return true;
}

/// The nodes around a point and D weights for each.
struct FittedRow {
  std::vector<int> nodes;
  std::vector<double> weights;
};

template <int D>
class PointGradient {
 public:
  PointGradient(const AnyKernel& kernel, double h, const VectorField<D>& points,
                const VectorField<D>& X, int order)
      : kernel_(kernel), h_(h), points_(points), X_(X), order_(order) {}

  [[nodiscard]] VectorOperator<D> make() const {
    Neighbours near = find_neighbours<D>(points_, X_, h_);
    std::vector<double> weights(near.column.size() * D);
    std::vector<Index> open;
    for (Index s = 0; s < points_.rows(); ++s)
      if (!fit(s, near.of(s), h_, singular, weights.data() + *near.entries(s).begin() * D))
        open.push_back(s);
    if (open.empty())
      return VectorOperator<D>(points_.rows(), X_.rows(), std::move(near), std::move(weights));
    const std::map<Index, FittedRow> wider = wider_rows(std::move(open));
    OperatorRows rows;
    for (Index s = 0; s < points_.rows(); ++s) {
      const auto found = wider.find(s);
      if (found != wider.end())
        rows.add_row(found->second.nodes, found->second.weights);
      else
        rows.add_row(near.of(s),
                     {weights.data() + *near.entries(s).begin() * D, near.of(s).size() * D});
    }
    return VectorOperator<D>(std::move(rows), X_.rows());
  }

 private:
  [[nodiscard]] bool fit(Index s, std::span<const int> nodes, double h, double least,
                         double* weights) const {
    const Support<D> support(kernel_, h, points_.row(s).transpose(), nodes, X_);
    return order_ > 1 ? fit_quadratic(support, least, weights)
                      : fit_linear(support, least, weights);
  }

  /// The fits at the points `open`, each over no more nodes than a well-conditioned one needs. All
  /// points that are left share the search of a radius.
  [[nodiscard]] std::map<Index, FittedRow> wider_rows(std::vector<Index> open) const {
    std::map<Index, FittedRow> rows;
    for (const double least : {well_conditioned, singular})
      for (double times = ratio; times <= widest && !open.empty(); times *= ratio) {
        const Neighbours near = find_neighbours<D>(points_(open, Eigen::all), X_, times * h_);
        std::vector<Index> left;
        for (std::size_t k = 0; k < open.size(); ++k) {
          const std::span<const int> nodes = near.of(static_cast<Index>(k));
          FittedRow row{{nodes.begin(), nodes.end()}, std::vector<double>(nodes.size() * D)};
          if (fit(open[k], nodes, times * h_, least, row.weights.data()))
            rows.emplace(open[k], std::move(row));
          else
            left.push_back(open[k]);
        }
        open = std::move(left);
      }
    if (!open.empty()) {
      const Vector<D> at = points_.row(open.front()).transpose();
      throw InputError(
          fmt::format("kernel.order: the nodes around ({:.6g}) do not determine a polynomial of "
                      "degree {}; choose a thicker body, a finer spacing or a lower degree",
                      fmt::join(at.data(), at.data() + D, ", "), order_));
    }
    return rows;
  }

  const AnyKernel& kernel_;
  double h_;
  const VectorField<D>& points_;
  const VectorField<D>& X_;
  int order_;
};

}  // namespace

template <int D>
VectorOperator<D> point_gradient(const AnyKernel& kernel, double h, const VectorField<D>& points,
                                 const VectorField<D>& X, int order) {
  return PointGradient<D>(kernel, h, points, X, order).make();
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template VectorOperator<D> point_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const VectorField<D>&, int);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph

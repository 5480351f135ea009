#include "tlsph/particles/interpolation.hpp"

#include <Eigen/Dense>
#include <utility>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Moments are scaled to the radius; below this the nodes lie (nearly) on a line.
constexpr double degenerate = 1e-3;

/// Fit over the nodes within `radius`; empty if they do not determine `rank` of its D + 1 unknowns.
template <int D>
InterpolationRow fit(const VectorField<D>& X, const Vector<D>& x, double radius, int rank) {
  using Basis = Eigen::Matrix<double, D + 1, 1>;
  using Moment = Eigen::Matrix<double, D + 1, D + 1>;
  InterpolationRow row;
  std::vector<Basis> basis;
  Moment moment = Moment::Zero();
  for (Index q = 0; q < X.rows(); ++q) {
    const Vector<D> arm = (X.row(q).transpose() - x) / radius;
    const double r = arm.norm();
    if (r >= 1.0) continue;
    Basis b;
    b << 1.0, arm;
    const double w = (1.0 - r) * (1.0 - r);
    row.node.push_back(q);
    row.weight.push_back(w);
    basis.push_back(b);
    moment += w * b * b.transpose();
  }
  if (row.node.size() < static_cast<std::size_t>(rank)) return {};
  moment /= moment(0, 0);
  const Eigen::SelfAdjointEigenSolver<Moment> spectrum(moment);
  const auto& eigenvalues = spectrum.eigenvalues();
  if (eigenvalues[D + 1 - rank] < degenerate) return {};
  // The direction in which the nodes do not differ, if any, is left out.
  Basis c = Basis::Zero();
  for (int k = 0; k <= D; ++k)
    if (eigenvalues[k] >= degenerate)
      c += spectrum.eigenvectors()(0, k) / eigenvalues[k] * spectrum.eigenvectors().col(k);
  double sum = 0.0;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    row.weight[k] *= c.dot(basis[k]);
    sum += row.weight[k];
  }
  for (double& w : row.weight) w /= sum;
  return row;
}

}  // namespace

template <int D>
InterpolationRow linear_interpolation(const VectorField<D>& X, const Vector<D>& x, double spacing) {
  Index nearest = 0;
  const double distance =
      std::sqrt((X.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&nearest));
  if (distance <= 1e-6 * spacing) return {{nearest}, {1.0}};
  // A body one cell thick has its stress points in one row: they tell two unknowns, the value and
  // the slope along it.
  for (const auto& [rank, reach] : {std::pair(D + 1, 20.0), std::pair(2, 2.0)})
    for (double radius = distance + 0.6 * spacing; radius < distance + reach * spacing;
         radius += 0.25 * spacing) {
      InterpolationRow row = fit<D>(X, x, radius, rank);
      if (!row.node.empty()) return row;
    }
  throw InputError(
      "no particles around the position determine a linear interpolation there; choose a finer "
      "spacing");
}

template InterpolationRow linear_interpolation<1>(const VectorField<1>&, const Vector<1>&, double);
template InterpolationRow linear_interpolation<2>(const VectorField<2>&, const Vector<2>&, double);

}  // namespace tlsph

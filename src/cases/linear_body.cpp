#include "linear_body.hpp"

#include <cmath>

#include "tlsph/dynamics/stiffness_matrix.hpp"

namespace tlsph {
namespace {

std::vector<Index> free_dofs(const Discretisation<2>& disc) {
  std::vector<Index> free;
  for (Index dof = 0; dof < disc.inverse_mass.size(); ++dof)
    if (disc.inverse_mass.data()[dof] > 0.0) free.push_back(dof);
  return free;
}

}  // namespace

LinearBody::LinearBody(const Discretisation<2>& disc)
    : disc_(disc), free_(free_dofs(disc)), factor_(among_free(disc, free_)) {}

SparseMatrix LinearBody::among_free(const Discretisation<2>& disc, const std::vector<Index>& free) {
  const SparseMatrix K = stiffness_matrix<2>(disc, TensorField<2>::Zero(disc.points.size(), 4));
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < free.size(); ++k)
    entries.emplace_back(static_cast<int>(k), static_cast<int>(free[k]), 1.0);
  SparseMatrix choose(static_cast<Index>(free.size()), K.rows());
  choose.setFromTriplets(entries.begin(), entries.end());
  return SparseMatrix(choose * K) * SparseMatrix(choose.transpose());
}

VectorField<2> LinearBody::at_rest(const VectorField<2>& forces) const {
  Eigen::VectorXd f(static_cast<Index>(free_.size()));
  for (Index k = 0; k < f.size(); ++k) f[k] = forces.data()[free_[static_cast<std::size_t>(k)]];
  const Eigen::VectorXd x = factor_.solve(f);
  VectorField<2> u = VectorField<2>::Zero(disc_.nodes(), 2);
  for (Index k = 0; k < f.size(); ++k) u.data()[free_[static_cast<std::size_t>(k)]] = x[k];
  return u;
}

double LinearBody::lowest_frequency() const {
  constexpr double enough = 1e-13;
  constexpr int most_rounds = 200;
  const auto n = static_cast<Index>(free_.size());
  Eigen::VectorXd mass(n);
  for (Index k = 0; k < n; ++k)
    mass[k] = 1.0 / disc_.inverse_mass.data()[free_[static_cast<std::size_t>(k)]];
  Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
  double square = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    x /= std::sqrt(x.dot(mass.cwiseProduct(x)));
    const Eigen::VectorXd image = mass.cwiseProduct(x);
    const Eigen::VectorXd y = factor_.solve(image);
    // Of the vector y: Rayleigh's quotient yᵀ K y / yᵀ M y with K y = M x.
    const double next = y.dot(image) / y.dot(mass.cwiseProduct(y));
    const bool done = std::abs(next - square) <= enough * next;
    square = next;
    x = y;
    if (done) break;
  }
  return std::sqrt(square);
}

}  // namespace tlsph

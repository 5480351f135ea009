#include "linear_body.hpp"

#include <cmath>

#include "tlsph/dynamics/stiffness_matrix.hpp"

namespace tlsph {
namespace {

std::vector<Index> free_dofs(const Discretisation<2>& body) {
  std::vector<Index> free;
  for (Index dof = 0; dof < body.inverse_mass.size(); ++dof)
    if (body.inverse_mass.data()[dof] > 0.0) free.push_back(dof);
  return free;
}

SparseMatrix stiffness(const Discretisation<2>& body) {
  return stiffness_matrix<2>(body, TensorField<2>::Zero(body.points.size(), 4));
}

}  // namespace

SparseMatrix among(const SparseMatrix& matrix, const std::vector<Index>& chosen) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    entries.emplace_back(static_cast<int>(k), static_cast<int>(chosen[k]), 1.0);
  SparseMatrix choose(static_cast<Index>(chosen.size()), matrix.rows());
  choose.setFromTriplets(entries.begin(), entries.end());
  return SparseMatrix(choose * matrix) * SparseMatrix(choose.transpose());
}

LinearBody::LinearBody(const Discretisation<2>& body)
    : body_(body), free_(free_dofs(body)), factor_(among(stiffness(body), free_)) {}

VectorField<2> LinearBody::at_rest(const VectorField<2>& forces) const {
  VectorField<2> u = VectorField<2>::Zero(body_.nodes(), 2);
  u.reshaped<Eigen::RowMajor>()(free_) =
      factor_.solve(Eigen::VectorXd(forces.reshaped<Eigen::RowMajor>()(free_)));
  return u;
}

double LinearBody::lowest_frequency() const {
  constexpr double enough = 1e-13;
  constexpr int most_rounds = 200;
  const Eigen::VectorXd mass = body_.inverse_mass.reshaped<Eigen::RowMajor>()(free_).cwiseInverse();
  Eigen::VectorXd x = Eigen::VectorXd::Ones(mass.size());
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

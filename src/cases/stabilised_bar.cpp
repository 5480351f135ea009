#include "stabilised_bar.hpp"

#include <vector>

#include "tlsph/operators/stabilisers.hpp"

namespace tlsph {

void add_one_sided_stabiliser(Discretisation<1>& bar, double coefficient) {
  const Index N = bar.nodes();
  std::vector<Eigen::Triplet<double>> difference;
  std::vector<Eigen::Triplet<double>> arm;
  std::vector<double> strength;
  const double modulus = tangent<1>(bar.regions.front().law, Tensor<1>::Zero())(0, 0);
  for (Index p = 0; p < N; ++p)
    for (const Index q : {p - 1, p + 1}) {
      if (q < 0 || q >= N) continue;
      const auto row = static_cast<int>(strength.size());
      const double distance = bar.particles.X(q, 0) - bar.particles.X(p, 0);
      difference.emplace_back(row, static_cast<int>(q), 1.0);
      difference.emplace_back(row, static_cast<int>(p), -1.0);
      arm.emplace_back(row, static_cast<int>(p), distance);
      strength.push_back(0.5 * coefficient * modulus * bar.spacing / (distance * distance));
    }
  const auto rows = static_cast<Index>(strength.size());
  SparseMatrix errors(rows, N);
  SparseMatrix arms(rows, N);
  errors.setFromTriplets(difference.begin(), difference.end());
  arms.setFromTriplets(arm.begin(), arm.end());
  errors -= SparseMatrix(arms * bar.gradient.matrix(0));
  const SparseMatrix S =
      normal_matrix(errors, Eigen::Map<const ScalarField>(strength.data(), rows));
  bar.stiffness = bar.stiffness.size() == 0 ? S : SparseMatrix(bar.stiffness + S);
}

}  // namespace tlsph

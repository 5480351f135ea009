#include "bar_spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/dynamics/state.hpp"

namespace tlsph {

std::vector<std::complex<double>> squared_frequencies(const Discretisation<1>& bar) {
  const Index nodes = bar.nodes();
  State<1> state =
      make_state<1>(bar, VectorField<1>::Zero(nodes, 1), VectorField<1>::Zero(nodes, 1));
  evaluate<1>(bar, state);
  const VectorField<1> at_rest = state.f;  // of the loads
  std::vector<Index> free;
  for (Index q = 0; q < nodes; ++q)
    if (bar.inverse_mass(q, 0) > 0.0) free.push_back(q);
  const auto n = static_cast<Index>(free.size());
  Eigen::MatrixXd matrix(n, n);
  for (Index column = 0; column < n; ++column) {
    const Index q = free[static_cast<std::size_t>(column)];
    state.u(q, 0) = 1.0;
    evaluate<1>(bar, state);
    state.u(q, 0) = 0.0;
    for (Index row = 0; row < n; ++row) {
      const Index p = free[static_cast<std::size_t>(row)];
      matrix(row, column) = (at_rest(p, 0) - state.f(p, 0)) * bar.inverse_mass(p, 0);
    }
  }
  return eigenvalues(SparseMatrix(matrix.sparseView()));
}

double growth_rate(const std::vector<std::complex<double>>& squared_frequencies) {
  double rate = 0.0;
  for (const std::complex<double>& square : squared_frequencies)
    rate = std::max(rate, std::abs(std::sqrt(-square).real()));
  return rate;
}

double growth_per_step(const std::vector<std::complex<double>>& squared_frequencies, double dt) {
  double largest = 0.0;
  for (const std::complex<double>& square : squared_frequencies) {
    // The roots of z² − 2bz + 1 are inverse to each other: either sign will do.
    const std::complex<double> b = 1.0 - 0.5 * square * dt * dt;
    largest = std::max(largest, std::abs(std::log(std::abs(b + std::sqrt(b * b - 1.0)))));
  }
  return largest;
}

}  // namespace tlsph

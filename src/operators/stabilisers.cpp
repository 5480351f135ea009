#include "tlsph/operators/stabilisers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace tlsph {
namespace {

/// Gives both triangles of a matrix with a symmetric pattern their mean, in place.
void symmetrise(SparseMatrix& matrix) {
  const int* start = matrix.outerIndexPtr();
  // In row q the entries left of the diagonal come up in the order of the rows p above it.
  std::vector<int> next(start, start + matrix.rows());
  for (Index p = 0; p < matrix.rows(); ++p)
    for (int k = start[p]; k < start[p + 1]; ++k) {
      const int q = matrix.innerIndexPtr()[k];
      if (q <= p) continue;
      double& upper = matrix.valuePtr()[k];
      double& lower = matrix.valuePtr()[next[static_cast<std::size_t>(q)]++];
      upper = lower = 0.5 * (upper + lower);
    }
}

}  // namespace

template <int D>
SparseMatrix pair_stabiliser(const VectorOperator<D>& gradient, const VectorField<D>& X,
                             const ScalarField& V, double spacing, const ScalarField& modulus) {
  const Index N = X.rows();
  const Neighbours near = find_neighbours<D>(X, X, pair_cutoff * spacing);
  std::array<SparseMatrix, D> G;
  for (int a = 0; a < D; ++a) G[static_cast<std::size_t>(a)] = gradient.matrix(a);

  // Rows a of the pair errors, scaled by √w, assembled as E = Q − Σ_a diag(d_a) ½(S_p + S_q) G^a.
  std::vector<Eigen::Triplet<double>> difference;
  std::array<std::vector<Eigen::Triplet<double>>, D> mean;
  std::vector<double> stiffness;
  for (Index p = 0; p < N; ++p)
    for (const Index q : near.of(p)) {
      if (q <= p) continue;
      const auto pair = static_cast<int>(stiffness.size());
      const Vector<D> arm = (X.row(q) - X.row(p)).transpose();
      const double root = std::sqrt(std::sqrt(V[p] * V[q])) / arm.norm();
      difference.emplace_back(pair, static_cast<int>(q), root);
      difference.emplace_back(pair, static_cast<int>(p), -root);
      for (int a = 0; a < D; ++a)
        for (const Index end : {p, q})
          mean[static_cast<std::size_t>(a)].emplace_back(pair, static_cast<int>(end),
                                                         0.5 * root * arm[a]);
      stiffness.push_back(0.5 * (modulus[p] + modulus[q]));
    }
  const auto pairs = static_cast<Index>(stiffness.size());
  SparseMatrix E(pairs, N);
  E.setFromTriplets(difference.begin(), difference.end());
  for (std::size_t a = 0; a < D; ++a) {
    SparseMatrix half(pairs, N);
    half.setFromTriplets(mean[a].begin(), mean[a].end());
    E -= SparseMatrix(half * G[a]);
  }
  return normal_matrix(E, Eigen::Map<const ScalarField>(stiffness.data(), pairs));
}

std::vector<double> hourglass_weights(const Particles<2>& particles,
                                      const VectorOperator<2>& gradient) {
  static constexpr std::array<double, 4> h = {1.0, -1.0, 1.0, -1.0};
  std::vector<double> weights(static_cast<std::size_t>(gradient.nonzeros()));
  for (std::size_t s = 0; s < particles.cells.size(); ++s) {
    const Cell<2>& cell = particles.cells[s];
    Vector<2> moment = Vector<2>::Zero();
    for (std::size_t c = 0; c < 4; ++c) moment += h[c] * particles.X.row(cell[c]).transpose();
    for (const Index k : gradient.pattern().entries(static_cast<Index>(s))) {
      const auto corner = static_cast<std::size_t>(
          std::ranges::find(cell, gradient.pattern().column_at(k)) - cell.begin());
      weights[static_cast<std::size_t>(k)] = 0.25 * (h[corner] - gradient.weight(k, 0) * moment[0] -
                                                     gradient.weight(k, 1) * moment[1]);
    }
  }
  return weights;
}

SparseMatrix hourglass_rows(const Particles<2>& particles, const VectorOperator<2>& gradient) {
  SparseMatrix rows = gradient.matrix(0);  // for its pattern
  std::ranges::copy(hourglass_weights(particles, gradient), rows.valuePtr());
  return rows;
}

SparseMatrix normal_matrix(const SparseMatrix& rows, const ScalarField& kappa) {
  SparseMatrix result = SparseMatrix(rows.transpose()) * SparseMatrix(kappa.asDiagonal() * rows);
  result.makeCompressed();
  // Round-off leaves the two triangles a few ulp apart; the energy wants them equal.
  symmetrise(result);
  return result;
}

#define TLSPH_INSTANTIATE(D)                                                                \
  template SparseMatrix pair_stabiliser<D>(const VectorOperator<D>&, const VectorField<D>&, \
                                           const ScalarField&, double, const ScalarField&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph

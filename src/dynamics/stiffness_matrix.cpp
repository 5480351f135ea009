#include "tlsph/dynamics/stiffness_matrix.hpp"

#include <array>
#include <cassert>
#include <vector>

#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph {
namespace {

/// A at every point.
template <int D>
std::vector<Tangent<D>> tangents(const Discretisation<D>& body, const TensorField<D>& H) {
  std::vector<Tangent<D>> A(static_cast<std::size_t>(H.rows()));
  for (const Region<D>& region : body.regions)
    for (Index k = 0; k < region.size(H.rows()); ++k) {
      const Index s = region.point(k);
      A[static_cast<std::size_t>(s)] = tangent<D>(region.law, tensor_at<D>(H, s));
    }
  return A;
}

}  // namespace

template <int D>
SparseMatrix stiffness_matrix(const Discretisation<D>& body, const TensorField<D>& H) {
  assert(body.adjoint);
  const std::vector<Tangent<D>> A = tangents<D>(body, H);
  std::array<SparseMatrix, D> G;
  std::array<SparseMatrix, D> adjoint;
  for (int a = 0; a < D; ++a) {
    G[static_cast<std::size_t>(a)] = body.gradient.matrix(a);
    adjoint[static_cast<std::size_t>(a)] = G[static_cast<std::size_t>(a)].transpose();
  }
  const SparseMatrix S = stabiliser_matrix<D>(body);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd scale(body.points.size());
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      SparseMatrix block(body.nodes(), body.nodes());
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) {
          for (Index s = 0; s < scale.size(); ++s)
            scale[s] = body.points.V[s] * A[static_cast<std::size_t>(s)](i * D + a, j * D + b);
          const SparseMatrix right = scale.asDiagonal() * G[static_cast<std::size_t>(b)];
          block += SparseMatrix(adjoint[static_cast<std::size_t>(a)] * right);
        }
      if (i == j && S.nonZeros() > 0) block += S;
      for (int q = 0; q < block.rows(); ++q)
        for (SparseMatrix::InnerIterator entry(block, q); entry; ++entry)
          entries.emplace_back(q * D + i, static_cast<int>(entry.col()) * D + j, entry.value());
    }
  SparseMatrix K(body.nodes() * D, body.nodes() * D);
  K.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix transposed = K.transpose();
  return 0.5 * (K + transposed);
}

template SparseMatrix stiffness_matrix<1>(const Discretisation<1>&, const TensorField<1>&);
template SparseMatrix stiffness_matrix<2>(const Discretisation<2>&, const TensorField<2>&);

}  // namespace tlsph

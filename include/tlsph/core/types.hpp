#pragma once
/// \file
/// The types every room shares. Storage order is stated here and nowhere else: a field of N rows is
/// **row-major**, so the components of one particle lie side by side in memory.

#include <Eigen/Core>
#include <Eigen/SparseCore>

/// X(D) for the dimensions a body may have: explicit instantiations of templates.
#define TLSPH_FOR_DIMENSIONS(X) X(1) X(2)

namespace tlsph {

/// Index of a particle, point, row or column.
using Index = Eigen::Index;

/// Eigen wants column-major for a one-column matrix; for one column both orders are the same bytes.
template <int Columns>
inline constexpr int storage_order = Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor;

/// A vector of d components: position, displacement, force at one particle.
template <int D>
using Vector = Eigen::Matrix<double, D, 1>;

/// A d×d tensor, row i = component i of the vector, column a = direction a of the derivative
/// (`F(i, a) = ∂x_i/∂X_a`).
template <int D>
using Tensor = Eigen::Matrix<double, D, D, storage_order<D>>;

/// A vector at every particle, N×d.
template <int D>
using VectorField = Eigen::Matrix<double, Eigen::Dynamic, D, storage_order<D>>;

/// A tensor at every material point, M×d²; column `i*D + a` holds component (i, a).
template <int D>
using TensorField = Eigen::Matrix<double, Eigen::Dynamic, D * D, storage_order<D * D>>;

/// A scalar at every particle or point, N×1.
using ScalarField = Eigen::VectorXd;

/// The plain sparse matrix every operator can become: compressed rows, 32-bit indices.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// The tensor of one row of a TensorField.
template <int D>
Tensor<D> tensor_at(const TensorField<D>& field, Index row) {
  return Eigen::Map<const Tensor<D>>(field.row(row).data());
}

}  // namespace tlsph

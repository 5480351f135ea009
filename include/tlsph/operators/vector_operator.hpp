#pragma once
/// \file
/// The one type behind every gradient G and force operator D: a sparse matrix whose entries are the
/// d weights of one pair, one a direction, so that each index is read once for all directions and
/// components. It becomes plain sparse matrices on request.
///
///     H = G u:   H_(ia) at s = Σ_q w^a_sq u_i at q         (M×d² from N×d)
///     f = D P:   f_i at q    = Σ_s Σ_a w^a_qs P_(ia) at s   (N×d from M×d²)

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "tlsph/core/types.hpp"
#include "tlsph/operators/neighbours.hpp"

namespace tlsph {

/// Rows of an operator under construction.
struct OperatorRows {
  Neighbours pattern{{0}, {}};
  std::vector<double> weights;

  void reserve(std::size_t rows, std::size_t entries_a_row, std::size_t weights_an_entry) {
    pattern.start.reserve(rows + 1);
    pattern.column.reserve(rows * entries_a_row);
    weights.reserve(rows * entries_a_row * weights_an_entry);
  }
  /// An entry of the row under way, columns ascending.
  void add(int column, std::span<const double> of_column) {
    pattern.column.push_back(column);
    weights.insert(weights.end(), of_column.begin(), of_column.end());
  }
  void end_row() { pattern.start.push_back(pattern.size()); }
  /// A whole row, the same number of weights a column.
  void add_row(std::span<const int> columns, std::span<const double> of_columns) {
    pattern.column.insert(pattern.column.end(), columns.begin(), columns.end());
    weights.insert(weights.end(), of_columns.begin(), of_columns.end());
    end_row();
  }
  /// A row from its entries in any order.
  template <int D>
  void add_row(std::vector<std::pair<int, Vector<D>>> entries) {
    std::ranges::sort(entries, {}, &std::pair<int, Vector<D>>::first);
    for (const auto& [column, weight] : entries) add(column, {weight.data(), D});
    end_row();
  }
};

template <int D>
class VectorOperator {
 public:
  VectorOperator() = default;
  /// `weights` holds `stride` numbers an entry: D (weights shared by all components; index a) or D²
  /// (weights differ by component, as mirrored boundaries need; index i*D + a).
  VectorOperator(Index rows, Index cols, Neighbours pattern, std::vector<double> weights);
  VectorOperator(OperatorRows rows, Index cols);

  [[nodiscard]] Index rows() const { return rows_; }
  [[nodiscard]] Index cols() const { return cols_; }
  /// Stored entries, each holding one weight a direction.
  [[nodiscard]] Index nonzeros() const { return pattern_.size(); }
  /// True when the weights differ by component.
  [[nodiscard]] bool per_component() const { return stride_ != D; }
  [[nodiscard]] const Neighbours& pattern() const { return pattern_; }
  /// Weight of entry k (position in `pattern().column`) in a direction, for a component.
  [[nodiscard]] double weight(Index k, int direction, int component = 0) const {
    const Index slot = per_component() ? component * D + direction : direction;
    return weights_[static_cast<std::size_t>(k * stride_ + slot)];
  }

  /// All weights, those of an entry side by side: D of them, or D² where they differ by component.
  [[nodiscard]] std::span<const double> weights() const { return weights_; }

  /// H = G u; `H` is resized by the caller.
  void gradient(const VectorField<D>& u, TensorField<D>& H) const;
  /// f = D P; `f` is resized by the caller.
  void divergence(const TensorField<D>& P, VectorField<D>& f) const;
  /// The same for one row alone.
  void gradient_row(Index s, const VectorField<D>& u, TensorField<D>& H) const;
  void divergence_row(Index q, const TensorField<D>& P, VectorField<D>& f) const;

  /// The plain sparse matrix of one direction (for one component where they differ).
  [[nodiscard]] SparseMatrix matrix(int direction, int component = 0) const;
  /// −GᵀV_s, the adjoint force operator; V_s [m^d] are the volumes of the rows.
  [[nodiscard]] VectorOperator negative_adjoint(const ScalarField& row_volumes) const;
  /// Rows scaled: diag(s) · this.
  [[nodiscard]] VectorOperator row_scaled(const ScalarField& scale) const;
  /// The same with rows that differ by rounding only made equal (operators/row_storage.hpp).
  [[nodiscard]] VectorOperator with_shared_rows(double tolerance) &&;
  /// Bytes of indices and weights.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// A row's sum, weights shared by all components or not.
  template <bool PerComponent>
  void gradient_of(Index s, const double* u, double* H) const;
  template <bool PerComponent>
  void divergence_of(Index q, const double* P, double* f) const;

  Index rows_ = 0;
  Index cols_ = 0;
  Index stride_ = D;
  Neighbours pattern_;
  std::vector<double> weights_;
};

}  // namespace tlsph

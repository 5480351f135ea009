#include "tlsph/operators/vector_operator.hpp"

#include <cassert>
#include <utility>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph {
template <int D>
VectorOperator<D>::VectorOperator(Index rows, Index cols, Neighbours pattern,
                                  std::vector<double> weights)
    : rows_(rows), cols_(cols), pattern_(std::move(pattern)), weights_(std::move(weights)) {
  assert(pattern_.rows() == rows_);
  const auto entries = pattern_.column.size();
  stride_ = entries == 0 ? D : static_cast<Index>(weights_.size() / entries);
  assert(stride_ == D || stride_ == D * D);
}

template <int D>
VectorOperator<D>::VectorOperator(std::span<const SparseMatrix> directions)
    : rows_(directions[0].rows()), cols_(directions[0].cols()) {
  assert(directions.size() == D);
  SparseMatrix everywhere(rows_, cols_);
  for (const SparseMatrix& matrix : directions) {
    SparseMatrix ones = matrix;
    for (Index k = 0; k < ones.nonZeros(); ++k) ones.valuePtr()[k] = 1.0;
    everywhere += ones;
  }
  everywhere.makeCompressed();
  pattern_.start.assign(everywhere.outerIndexPtr(), everywhere.outerIndexPtr() + rows_ + 1);
  pattern_.column.assign(everywhere.innerIndexPtr(),
                         everywhere.innerIndexPtr() + everywhere.nonZeros());
  weights_.assign(pattern_.column.size() * D, 0.0);
  for (int a = 0; a < D; ++a) {
    const SparseMatrix& matrix = directions[static_cast<std::size_t>(a)];
    for (Index s = 0; s < rows_; ++s) {
      Index k = pattern_.start[static_cast<std::size_t>(s)];
      for (SparseMatrix::InnerIterator it(matrix, s); it; ++it) {
        while (pattern_.column[static_cast<std::size_t>(k)] != it.col()) ++k;
        weights_[static_cast<std::size_t>(k * D + a)] = it.value();
      }
    }
  }
}

template <int D>
template <bool PerComponent>
void VectorOperator<D>::gradient_of(Index s, const double* u, double* H) const {
  constexpr int numbers = PerComponent ? D * D : D;
  const Index* start = pattern_.start.data();
  const int* column = pattern_.column.data();
  double sum[D * D] = {};
  for (Index k = start[s]; k < start[s + 1]; ++k) {
    const double* w = weights_.data() + k * numbers;
    const double* value = u + static_cast<Index>(column[k]) * D;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) sum[i * D + a] += w[PerComponent ? i * D + a : a] * value[i];
  }
  for (int c = 0; c < D * D; ++c) H[s * D * D + c] = sum[c];
}

template <int D>
template <bool PerComponent>
void VectorOperator<D>::divergence_of(Index q, const double* P, double* f) const {
  constexpr int numbers = PerComponent ? D * D : D;
  const Index* start = pattern_.start.data();
  const int* column = pattern_.column.data();
  double sum[D] = {};
  for (Index k = start[q]; k < start[q + 1]; ++k) {
    const double* w = weights_.data() + k * numbers;
    const double* stress = P + static_cast<Index>(column[k]) * D * D;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) sum[i] += w[PerComponent ? i * D + a : a] * stress[i * D + a];
  }
  for (int i = 0; i < D; ++i) f[q * D + i] = sum[i];
}

template <int D>
void VectorOperator<D>::gradient(const VectorField<D>& u, TensorField<D>& H) const {
  assert(u.rows() == cols_ && H.rows() == rows_);
  const double* in = u.data();
  double* out = H.data();
  if (per_component())
    for_rows(rows_, [=, this](Index s) { gradient_of<true>(s, in, out); });
  else
    for_rows(rows_, [=, this](Index s) { gradient_of<false>(s, in, out); });
}

template <int D>
void VectorOperator<D>::divergence(const TensorField<D>& P, VectorField<D>& f) const {
  assert(P.rows() == cols_ && f.rows() == rows_);
  const double* in = P.data();
  double* out = f.data();
  if (per_component())
    for_rows(rows_, [=, this](Index q) { divergence_of<true>(q, in, out); });
  else
    for_rows(rows_, [=, this](Index q) { divergence_of<false>(q, in, out); });
}

template <int D>
void VectorOperator<D>::gradient_row(Index s, const VectorField<D>& u, TensorField<D>& H) const {
  if (per_component())
    gradient_of<true>(s, u.data(), H.data());
  else
    gradient_of<false>(s, u.data(), H.data());
}

template <int D>
void VectorOperator<D>::divergence_row(Index q, const TensorField<D>& P, VectorField<D>& f) const {
  if (per_component())
    divergence_of<true>(q, P.data(), f.data());
  else
    divergence_of<false>(q, P.data(), f.data());
}

template <int D>
SparseMatrix VectorOperator<D>::matrix(int direction, int component) const {
  SparseMatrix result(rows_, cols_);
  result.resizeNonZeros(nonzeros());
  for (Index s = 0; s <= rows_; ++s)
    result.outerIndexPtr()[s] = static_cast<int>(pattern_.start[static_cast<std::size_t>(s)]);
  for (Index k = 0; k < nonzeros(); ++k) {
    result.innerIndexPtr()[k] = pattern_.column[static_cast<std::size_t>(k)];
    result.valuePtr()[k] = weight(k, direction, component);
  }
  return result;
}

template <int D>
VectorOperator<D> VectorOperator<D>::negative_adjoint(const ScalarField& row_volumes) const {
  assert(row_volumes.size() == rows_);
  Neighbours transposed;
  transposed.start.assign(static_cast<std::size_t>(cols_) + 1, 0);
  for (int q : pattern_.column) ++transposed.start[static_cast<std::size_t>(q) + 1];
  for (std::size_t q = 1; q < transposed.start.size(); ++q)
    transposed.start[q] += transposed.start[q - 1];
  transposed.column.resize(pattern_.column.size());
  std::vector<double> weights(weights_.size());
  std::vector<Index> next(transposed.start.begin(), transposed.start.end() - 1);
  for (Index s = 0; s < rows_; ++s) {
    const auto row = static_cast<std::size_t>(s);
    for (Index k = pattern_.start[row]; k < pattern_.start[row + 1]; ++k) {
      const auto q = static_cast<std::size_t>(pattern_.column[static_cast<std::size_t>(k)]);
      const Index place = next[q]++;
      transposed.column[static_cast<std::size_t>(place)] = static_cast<int>(s);
      for (Index c = 0; c < stride_; ++c)
        weights[static_cast<std::size_t>(place * stride_ + c)] =
            -row_volumes[s] * weights_[static_cast<std::size_t>(k * stride_ + c)];
    }
  }
  return VectorOperator(cols_, rows_, std::move(transposed), std::move(weights));
}

template <int D>
VectorOperator<D> VectorOperator<D>::row_scaled(const ScalarField& scale) const {
  VectorOperator result = *this;
  for (Index s = 0; s < rows_; ++s) {
    const auto row = static_cast<std::size_t>(s);
    for (Index k = pattern_.start[row] * stride_; k < pattern_.start[row + 1] * stride_; ++k)
      result.weights_[static_cast<std::size_t>(k)] *= scale[s];
  }
  return result;
}

template <int D>
VectorOperator<D> VectorOperator<D>::with_shared_rows(double tolerance) && {
  write_shared(share_rows(pattern_, weights_, static_cast<int>(stride_), tolerance), pattern_,
               weights_);
  return std::move(*this);
}

template <int D>
std::size_t VectorOperator<D>::bytes() const {
  return pattern_.start.size() * sizeof(Index) + pattern_.column.size() * sizeof(int) +
         weights_.size() * sizeof(double);
}

template class VectorOperator<1>;
template class VectorOperator<2>;

}  // namespace tlsph

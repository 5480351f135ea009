#include "tlsph/operators/vector_operator.hpp"

#include <cassert>
#include <utility>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph {

template <int D>
VectorOperator<D>::VectorOperator(OperatorRows rows, Index cols)
    : rows_(rows.pattern.rows()),
      cols_(cols),
      pattern_(std::move(rows.pattern)),
      weights_(std::move(rows.weights)) {
  const auto entries = pattern_.column.size();
  stride_ = entries == 0 ? D : static_cast<Index>(weights_.size() / entries);
  assert(stride_ == D || stride_ == D * D);
}

template <int D>
VectorOperator<D>::VectorOperator([[maybe_unused]] Index rows, Index cols, Neighbours pattern,
                                  std::vector<double> weights)
    : VectorOperator(OperatorRows{std::move(pattern), std::move(weights)}, cols) {
  assert(rows_ == rows);
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
  return matrix_of(pattern_, cols_, [&](Index k) { return weight(k, direction, component); });
}

template <int D>
VectorOperator<D> VectorOperator<D>::negative_adjoint(const ScalarField& row_volumes) const {
  assert(row_volumes.size() == rows_);
  ByColumns transposed = by_columns(pattern_, cols_);
  std::vector<double> weights;
  weights.reserve(weights_.size());
  for (std::size_t t = 0; t < transposed.entry.size(); ++t) {
    const double factor = -row_volumes[transposed.rows.column[t]];
    for (Index c = 0; c < stride_; ++c)
      weights.push_back(factor *
                        weights_[static_cast<std::size_t>(transposed.entry[t] * stride_ + c)]);
  }
  return VectorOperator(cols_, rows_, std::move(transposed.rows), std::move(weights));
}

template <int D>
VectorOperator<D> VectorOperator<D>::row_scaled(const ScalarField& scale) const {
  VectorOperator result = *this;
  for (Index s = 0; s < rows_; ++s)
    for (const Index k : pattern_.entries(s))
      for (Index c = 0; c < stride_; ++c)
        result.weights_[static_cast<std::size_t>(k * stride_ + c)] *= scale[s];
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

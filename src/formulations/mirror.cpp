#include "tlsph/formulations/mirror.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Rows under construction: columns with their weights, and signal terms.
template <int D>
class FoldedRows {
 public:
  static constexpr int stride = D == 1 ? 1 : D * D;

  void add(const Image& image, int component, double weight, Index slot) {
    if (image.sign != 0.0)
      row_[static_cast<int>(image.node)][static_cast<std::size_t>(component)] +=
          weight * image.sign;
    for (std::size_t k = 0; k < image.count; ++k)
      terms_[{slot, image.terms[k].signal}] += weight * image.terms[k].weight;
  }
  void end_row() {
    for (const auto& [column, values] : row_) {
      pattern_.column.push_back(column);
      weights_.insert(weights_.end(), values.begin(), values.end());
    }
    pattern_.start.push_back(static_cast<Index>(pattern_.column.size()));
    row_.clear();
  }
  [[nodiscard]] VectorOperator<D> finish(Index rows) {
    return VectorOperator<D>(rows, rows, std::move(pattern_), std::move(weights_));
  }
  [[nodiscard]] std::vector<SignalTerm> terms() const {
    std::vector<SignalTerm> result;
    for (const auto& [key, weight] : terms_) result.push_back({key.first, key.second, weight});
    return result;
  }

 private:
  Neighbours pattern_{{0}, {}};
  std::vector<double> weights_;
  std::map<int, std::array<double, stride>> row_;
  std::map<std::pair<Index, std::size_t>, double> terms_;
};

template <int D>
std::vector<SignalTerm> edge_stresses(const LatticeFrame<D>& frame, const Edges<D>& edges,
                                      Index nodes) {
  std::vector<SignalTerm> values;
  for (Index p = 0; p < nodes; ++p) {
    const auto at = frame.coordinates(static_cast<int>(p));
    for (int b = 0; b < D; ++b) {
      const auto d = static_cast<std::size_t>(b);
      if (at[d] != 0 && at[d] != frame.counts[d] - 1) continue;
      const Edge<D>& edge = edges[d][at[d] == 0 ? 0 : 1];
      for (int i = 0; i < D; ++i) {
        if (edge.prescribed[static_cast<std::size_t>(i)]) continue;
        const std::size_t signal = i == b ? edge.traction : no_signal;
        values.push_back({p * D * D + i * D + b, signal, signal == no_signal ? 0.0 : 1.0});
      }
    }
  }
  return values;
}

}  // namespace

template <int D>
FoldedOperators<D> folded_operators(const LatticeStencil<D>& stencil, const LatticeFrame<D>& frame,
                                    const ScalarField& V, const Edges<D>& edges,
                                    TractionGhost ghost) {
  for (std::size_t a = 0; a < D; ++a)
    if (frame.counts[a] - 1 < stencil.reach)
      throw InputError(fmt::format(
          "kernel.support: the kernel reaches {} particles, but the body is only {} cells thick; "
          "choose a smaller support or spacing",
          stencil.reach, frame.counts[a] - 1));
  const Index N = V.size();
  FoldedRows<D> gradient;
  FoldedRows<D> divergence;
  for (Index p = 0; p < N; ++p) {
    const auto at = frame.coordinates(static_cast<int>(p));
    for (std::size_t k = 0; k < stencil.offset.size(); ++k) {
      auto target = at;
      for (std::size_t a = 0; a < D; ++a) target[a] += stencil.offset[k][a];
      const Vector<D>& g = stencil.gradient[k];
      for (int i = 0; i < D; ++i) {
        const Image u = displacement_image<D>(frame, edges, target, i);
        for (int a = 0; a < D; ++a) {
          const int c = i * D + a;
          gradient.add(u, c, g[a], p * D * D + c);
          const Image stress = stress_image<D>(frame, edges, target, i, a, ghost);
          divergence.add(stress, c, V[p] * g[a], p * D + i);
        }
      }
    }
    gradient.end_row();
    divergence.end_row();
  }
  FoldedOperators<D> result;
  result.gradient_terms = gradient.terms();
  result.force_terms = divergence.terms();
  result.stress_values = edge_stresses<D>(frame, edges, N);
  result.gradient = gradient.finish(N);
  result.divergence = divergence.finish(N);
  return result;
}

#define TLSPH_INSTANTIATE(D)                                                                  \
  template FoldedOperators<D> folded_operators<D>(const LatticeStencil<D>&,                   \
                                                  const LatticeFrame<D>&, const ScalarField&, \
                                                  const Edges<D>&, TractionGhost);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

#include "tlsph/formulations/extension.hpp"

#include <fmt/format.h>

#include <cassert>
#include <map>
#include <utility>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// Reflects `at` into the box, one direction after the other; `across(edge, b, upper, distance)` is
/// told of each edge crossed, outermost first.
template <int D, class Across>
std::array<int, D> reflect(const LatticeFrame<D>& frame, const Edges<D>& edges,
                           std::array<int, D> at, const Across& across) {
  for (int b = 0; b < D; ++b) {
    const auto d = static_cast<std::size_t>(b);
    const int n = frame.counts[d] - 1;
    if (at[d] >= 0 && at[d] <= n) continue;
    const bool upper = at[d] > n;
    const int steps = upper ? at[d] - n : -at[d];
    assert(steps <= n);
    across(edges[d][upper ? 1 : 0], b, upper, steps * frame.spacing[b]);
    at[d] = upper ? n - steps : steps;
  }
  return at;
}

/// Image of P_ia.
template <int D>
Image stress_image(const LatticeFrame<D>& frame, const Edges<D>& edges, std::array<int, D> at,
                   int i, int a, TractionGhost ghost) {
  Image image;
  const auto component = static_cast<std::size_t>(i);
  const auto inside = reflect<D>(
      frame, edges, at, [&](const Edge<D>& edge, int b, bool /*upper*/, double /*distance*/) {
        if (b == a) {
          if (edge.prescribed[component]) return;
          const bool mirrored = ghost == TractionGhost::mirrored || edge.symmetry;
          if (i == b) image.add(edge.traction, mirrored ? 2.0 : 1.0);
          image.sign = mirrored ? -image.sign : 0.0;
        } else if ((edge.symmetry && i == b) || (edge.antisymmetry && i != b)) {
          image.sign = -image.sign;
        }
      });
  image.node = frame.index(inside);
  return image;
}

/// Rows under construction: columns with their weights, and signal terms.
template <int D>
class FoldedRows {
 public:
  void add(const Image& image, int component, double weight, Index slot) {
    if (image.sign != 0.0)
      row_[static_cast<int>(image.node)][static_cast<std::size_t>(component)] +=
          weight * image.sign;
    for (std::size_t k = 0; k < image.count; ++k)
      terms_[{slot, image.terms[k].signal}] += weight * image.terms[k].weight;
  }
  void end_row() {
    for (const auto& [column, weights] : row_) rows_.add(column, weights);
    rows_.end_row();
    row_.clear();
  }
  [[nodiscard]] VectorOperator<D> finish(Index cols) {
    return VectorOperator<D>(std::move(rows_), cols);
  }
  [[nodiscard]] std::vector<SignalTerm> terms() const {
    std::vector<SignalTerm> result;
    for (const auto& [key, weight] : terms_) result.push_back({key.first, key.second, weight});
    return result;
  }

 private:
  OperatorRows rows_;
  std::map<int, std::array<double, D * D>> row_;
  std::map<std::pair<Index, std::size_t>, double> terms_;
};

template <int D>
std::vector<SignalTerm> edge_stresses(const LatticeFrame<D>& frame, const Edges<D>& edges,
                                      Index nodes) {
  std::vector<SignalTerm> values;
  for (Index p = 0; p < nodes; ++p)
    for_edges<D>(
        edges, frame, frame.coordinates(static_cast<int>(p)), [&](const Edge<D>& edge, int b) {
          for (int i = 0; i < D; ++i) {
            if (edge.prescribed[static_cast<std::size_t>(i)]) continue;
            const std::size_t signal = i == b ? edge.traction : no_signal;
            values.push_back({p * D * D + i * D + b, signal, signal == no_signal ? 0.0 : 1.0});
          }
        });
  return values;
}

}  // namespace

template <int D>
Image displacement_image(const LatticeFrame<D>& frame, const Edges<D>& edges, std::array<int, D> at,
                         int i) {
  Image image;
  const auto component = static_cast<std::size_t>(i);
  const auto inside =
      reflect<D>(frame, edges, at, [&](const Edge<D>& edge, int b, bool upper, double distance) {
        if (edge.prescribed[component]) {
          image.add(edge.displacement[component], 2.0);
          image.sign = -image.sign;
        } else if (i == b) {
          image.add(edge.gradient, (upper ? 2.0 : -2.0) * distance);
        }
      });
  image.node = frame.index(inside);
  return image;
}

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
  template Image displacement_image<D>(const LatticeFrame<D>&, const Edges<D>&,               \
                                       std::array<int, D>, int);                              \
  template FoldedOperators<D> folded_operators<D>(const LatticeStencil<D>&,                   \
                                                  const LatticeFrame<D>&, const ScalarField&, \
                                                  const Edges<D>&, TractionGhost);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

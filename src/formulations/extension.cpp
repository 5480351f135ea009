#include "tlsph/formulations/extension.hpp"

#include <cassert>

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

#define TLSPH_INSTANTIATE(D)                                                                       \
  template Image displacement_image<D>(const LatticeFrame<D>&, const Edges<D>&,                    \
                                       std::array<int, D>, int);                                   \
  template Image stress_image<D>(const LatticeFrame<D>&, const Edges<D>&, std::array<int, D>, int, \
                                 int, TractionGhost);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

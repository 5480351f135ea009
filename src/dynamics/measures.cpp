#include "tlsph/dynamics/measures.hpp"

#include <algorithm>

#include "tlsph/materials/stress.hpp"

namespace tlsph {

template <int D>
StressMeasures<D> stress_measures(const Region<D>& region, const Tensor<D>& H, const Tensor<D>& P,
                                  const Past& past) {
  const Tensor<D> sigma = cauchy<D>(region.law, H, P, past);
  const double transverse = transverse_stress<D>(region.law, H, past);
  return {sigma, pressure<D>(sigma, transverse), von_mises<D>(sigma, transverse)};
}

template <int D>
std::size_t region_of(const Discretisation<D>& body, Index point) {
  for (std::size_t r = 0; r < body.regions.size(); ++r) {
    const auto& points = body.regions[r].points;
    if (points.empty() || std::binary_search(points.begin(), points.end(), point)) return r;
  }
  return 0;
}

#define TLSPH_INSTANTIATE(D)                                                        \
  template StressMeasures<D> stress_measures<D>(const Region<D>&, const Tensor<D>&, \
                                                const Tensor<D>&, const Past&);     \
  template std::size_t region_of<D>(const Discretisation<D>&, Index);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

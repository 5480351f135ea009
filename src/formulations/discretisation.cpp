#include "tlsph/formulations/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tlsph {
namespace {

/// The load of a traction whose component i, times the area of a face, is traction(face, i).
template <int D, class Traction>
Load load_of(const Patch<D>& patch, const Curve& curve, const Traction& traction) {
  std::map<Index, double> weights;
  for (const Face<D>& face : patch.faces)
    for (std::size_t k = 0; k < D; ++k)
      for (int i = 0; i < D; ++i)
        weights[Index{face.nodes[k]} * D + i] += face.share[k] * traction(face, i);
  Load load;
  load.curve = curve;
  for (const auto& [dof, weight] : weights) {
    if (weight == 0.0) continue;
    load.dof.push_back(dof);
    load.weight.push_back(weight);
  }
  return load;
}

}  // namespace

template <int D>
Load normal_traction(const Patch<D>& patch, const Curve& curve) {
  return load_of<D>(patch, curve, [](const Face<D>& face, int i) { return face.area[i]; });
}

template <int D>
Load component_traction(const Patch<D>& patch, int component, const Curve& curve) {
  return load_of<D>(patch, curve, [=](const Face<D>& face, int i) {
    return i == component ? face.area.norm() : 0.0;
  });
}

template <int D>
std::vector<ReactionTerm> reaction_terms(const Patch<D>& patch, int i) {
  std::vector<ReactionTerm> terms;
  for (const Face<D>& face : patch.faces)
    for (std::size_t k = 0; k < D; ++k)
      for (int a = 0; a < D; ++a)
        if (const double weight = face.share[k] * face.area[a]; weight != 0.0)
          terms.push_back(
              {Index{face.nodes[k]} * D + i, Index{face.nodes[k]} * D * D + i * D + a, weight});
  return terms;
}

template <int D>
bool Discretisation<D>::small_strain() const {
  return std::ranges::all_of(
      regions, [](const Region<D>& region) { return tlsph::small_strain<D>(region.law); });
}

template <int D>
int Discretisation<D>::memory() const {
  int most = 0;
  for (const Region<D>& region : regions) most = std::max(most, tlsph::memory<D>(region.law));
  return most;
}

template <int D>
double Discretisation<D>::wave_speed() const {
  double fastest = 0.0;
  for (const Region<D>& region : regions) {
    const double modulus = tangent<D>(region.law, Tensor<D>::Zero())(0, 0);
    fastest = std::max(fastest, std::sqrt(modulus / region.density));
  }
  return fastest;
}

#define TLSPH_INSTANTIATE(D)                                                  \
  template Load normal_traction<D>(const Patch<D>&, const Curve&);            \
  template Load component_traction<D>(const Patch<D>&, int, const Curve&);    \
  template std::vector<ReactionTerm> reaction_terms<D>(const Patch<D>&, int); \
  template struct Discretisation<D>;
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

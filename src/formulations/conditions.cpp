#include "tlsph/formulations/conditions.hpp"

#include <map>

namespace tlsph {
namespace {

Load load_from(const std::map<Index, double>& weights, const Curve& curve) {
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
  std::map<Index, double> weights;
  for (const Face<D>& face : patch.faces)
    for (std::size_t k = 0; k < D; ++k)
      for (int i = 0; i < D; ++i)
        weights[Index{face.nodes[k]} * D + i] += face.share[k] * face.area[i];
  return load_from(weights, curve);
}

template <int D>
Load component_traction(const Patch<D>& patch, int component, const Curve& curve) {
  std::map<Index, double> weights;
  for (const Face<D>& face : patch.faces)
    for (std::size_t k = 0; k < D; ++k)
      weights[Index{face.nodes[k]} * D + component] += face.share[k] * face.area.norm();
  return load_from(weights, curve);
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

template Load normal_traction<1>(const Patch<1>&, const Curve&);
template Load normal_traction<2>(const Patch<2>&, const Curve&);
template Load component_traction<1>(const Patch<1>&, int, const Curve&);
template Load component_traction<2>(const Patch<2>&, int, const Curve&);
template std::vector<ReactionTerm> reaction_terms<1>(const Patch<1>&, int);
template std::vector<ReactionTerm> reaction_terms<2>(const Patch<2>&, int);

}  // namespace tlsph

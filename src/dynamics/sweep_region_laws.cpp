#include "sweep_region_laws.hpp"

#include <type_traits>
#include <variant>

namespace tlsph::sweep {
namespace {

template <class Law, template <int, Assumption> class Listed, int D>
constexpr bool is = std::is_same_v<Law, Listed<D, Assumption::strain>> ||
                    std::is_same_v<Law, Listed<D, Assumption::stress>>;

template <int D>
RegionLaw<D> law_of(const AnyLaw<D>& any, const Kernels<D>& kernels) {
  return std::visit(
      [&]<class Law>(const Law& law) -> RegionLaw<D> {
        if constexpr (is<Law, LinearElastic, D>) {
          return {kernels.linear_elastic, {law.lambda(), law.mu()}};
        } else if constexpr (std::is_same_v<Law, StVenantKirchhoff<D, Assumption::strain>>) {
          return {kernels.st_venant_kirchhoff, {law.lambda(), law.mu()}};
        } else if constexpr (std::is_same_v<Law, StVenantKirchhoff<D, Assumption::stress>>) {
          return {kernels.st_venant_kirchhoff_free, {law.lambda(), law.mu()}};
        } else if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::strain>>) {
          return {kernels.neo_hookean, {law.lambda(), law.mu()}};
        } else if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::stress>>) {
          if (law.lambda() >= 0.0) return {kernels.neo_hookean_free, {law.lambda(), law.mu()}};
        }
        return {{}, {}, &any};
      },
      any);
}

template <int D>
RegionLaw<D> small_strain_law_of(const AnyLaw<D>& any, const Kernels<D>& kernels) {
  return std::visit(
      [&]<class Law>(const Law& law) -> RegionLaw<D> {
        if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::stress>>)
          return {kernels.linear_elastic,
                  {reduced_lambda({law.lambda(), law.mu()}, D, Assumption::stress), law.mu()}};
        else if constexpr (is<Law, LinearElastic, D> || is<Law, StVenantKirchhoff, D> ||
                           is<Law, NeoHookean, D>)
          return {kernels.linear_elastic, {law.lambda(), law.mu()}};
        else
          return {{}, {}, &any, true};
      },
      any);
}

}  // namespace

template <int D>
std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& disc, const Kernels<D>& kernels,
                                      bool linearised) {
  std::vector<RegionLaw<D>> laws;
  for (const Region<D>& region : disc.regions)
    laws.push_back(linearised ? small_strain_law_of<D>(region.law, kernels)
                              : law_of<D>(region.law, kernels));
  return laws;
}

template <int D>
std::vector<int> regions_of_points(const Discretisation<D>& disc) {
  if (disc.regions.size() < 2) return {};
  std::vector<int> regions(static_cast<std::size_t>(disc.points.size()), 0);
  for (std::size_t r = 0; r < disc.regions.size(); ++r)
    for (const int s : disc.regions[r].points)
      regions[static_cast<std::size_t>(s)] = static_cast<int>(r);
  return regions;
}

template std::vector<RegionLaw<1>> region_laws<1>(const Discretisation<1>&, const Kernels<1>&,
                                                  bool);
template std::vector<RegionLaw<2>> region_laws<2>(const Discretisation<2>&, const Kernels<2>&,
                                                  bool);
template std::vector<int> regions_of_points<1>(const Discretisation<1>&);
template std::vector<int> regions_of_points<2>(const Discretisation<2>&);

}  // namespace tlsph::sweep

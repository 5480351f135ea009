#include "sweep_region_laws.hpp"

#include <type_traits>
#include <variant>

namespace tlsph::sweep {
namespace {

template <int D>
RegionLaw<D> law_of(const AnyLaw<D>& any, const Kernels<D>& kernels) {
  return std::visit(
      [&](const auto& law) -> RegionLaw<D> {
        using Law = std::decay_t<decltype(law)>;
        const LawConstants constants{law.lambda(), law.mu()};
        if constexpr (Law::name == LinearElastic<D>::name)
          return {kernels.linear_elastic, constants, nullptr};
        else if constexpr (Law::name == StVenantKirchhoff<D>::name)
          return {kernels.st_venant_kirchhoff, constants, nullptr};
        else if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::strain>>)
          return {kernels.neo_hookean, constants, nullptr};
        else if (law.lambda() >= 0.0)
          return {kernels.neo_hookean_free, constants, nullptr};
        else
          return {{}, constants, &any};
      },
      any);
}

template <int D>
RegionLaw<D> small_strain_law_of(const AnyLaw<D>& any, const Kernels<D>& kernels) {
  const double lambda = std::visit(
      [](const auto& law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::stress>>)
          return reduced_lambda({law.lambda(), law.mu()}, D, Assumption::stress);
        else
          return law.lambda();
      },
      any);
  const double mu = std::visit([](const auto& law) { return law.mu(); }, any);
  return {kernels.linear_elastic, {lambda, mu}, nullptr};
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

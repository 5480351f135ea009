#include "region_laws.hpp"

#include <variant>

namespace tlsph::sweep {

template <int D>
const void* RegionLaw<D>::text() const {
  return std::visit(
      [](const auto& held) -> const void* {
        if constexpr (requires { held.text(); })
          return &held.text();
        else
          return nullptr;
      },
      law);
}

template <int D>
std::vector<RegionLaw<D>> region_laws(const Discretisation<D>& disc, const Loops<D>& loops,
                                      bool linearised) {
  std::vector<RegionLaw<D>> result;
  for (const Region<D>& region : disc.regions) {
    const std::optional<AnyLaw<D>> linear = linearised ? at_rest<D>(region.law) : std::nullopt;
    RegionLaw<D> law{linear.value_or(region.law), nullptr, linearised && !linear};
    const std::size_t index = law.law.index();
    if (index < std::size(loops.laws) && !law.linearised && tlsph::memory<D>(law.law) == 0)
      law.loops = &loops.laws[index];
    result.push_back(std::move(law));
  }
  return result;
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

template struct RegionLaw<1>;
template struct RegionLaw<2>;
template std::vector<RegionLaw<1>> region_laws<1>(const Discretisation<1>&, const Loops<1>&, bool);
template std::vector<RegionLaw<2>> region_laws<2>(const Discretisation<2>&, const Loops<2>&, bool);
template std::vector<int> regions_of_points<1>(const Discretisation<1>&);
template std::vector<int> regions_of_points<2>(const Discretisation<2>&);

}  // namespace tlsph::sweep

#include "tlsph/observe/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tlsph/core/error.hpp"

namespace tlsph {

template <int D>
const Quantity<D>* find_quantity(std::string_view name) {
  const auto& all = quantities<D>;
  const auto* const found = std::ranges::find(all, name, &Quantity<D>::name);
  return found == all.end() ? nullptr : found;
}

template <int D>
const Quantity<D>& quantity_named(std::string_view name) {
  if (const Quantity<D>* found = find_quantity<D>(name)) return *found;
  throw InputError(
      fmt::format("no quantity \"{}\"; choose from {}", name, fmt::join(quantity_names, ", ")));
}

template <int D>
std::vector<std::string> component_suffixes(const Quantity<D>& quantity) {
  const std::vector<std::string> names = component_names(quantity.rank, D);
  std::vector<std::string> suffixes;
  for_components<D>(quantity.rank, quantity.symmetric, [&](int i, int j) {
    const int k = quantity.rank == Rank::tensor ? i * D + j : i;
    const std::string& name = names[static_cast<std::size_t>(k)];
    suffixes.push_back(name.empty() ? "" : std::string("_").append(name));
  });
  return suffixes;
}

template <int D>
Observed<D> observed_particle(const Instant<D>& now, Index particle) {
  Observed<D> seen;
  for (int i = 0; i < D; ++i) {
    const NodalMotion motion = now.motion(particle * D + i);
    seen.u[i] = now.u()(particle, i);
    seen.v[i] = motion.velocity;
    seen.a[i] = motion.acceleration;
  }
  return seen;
}

template <int D>
Observed<D> observed_strain(const Instant<D>& now, Index point) {
  Observed<D> seen;
  seen.H = tensor_at<D>(now.H(), point);
  seen.P = tensor_at<D>(now.P(), point);
  return seen;
}

template <int D>
Observed<D> observed_point(const Instant<D>& now, Index point) {
  Observed<D> seen = observed_strain<D>(now, point);
  seen.stress = stress_measures<D>(now.body.regions[region_of<D>(now.body, point)], seen.H, seen.P,
                                   present(now.state, point));
  return seen;
}

#define TLSPH_INSTANTIATE(D)                                                   \
  template const Quantity<D>* find_quantity<D>(std::string_view);              \
  template const Quantity<D>& quantity_named<D>(std::string_view);             \
  template std::vector<std::string> component_suffixes<D>(const Quantity<D>&); \
  template Observed<D> observed_particle<D>(const Instant<D>&, Index);         \
  template Observed<D> observed_strain<D>(const Instant<D>&, Index);           \
  template Observed<D> observed_point<D>(const Instant<D>&, Index);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

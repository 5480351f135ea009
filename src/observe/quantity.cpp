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
Observed<D> observed_point(const Instant<D>& now, Index point) {
  Observed<D> seen;
  seen.H = tensor_at<D>(now.H(), point);
  seen.P = tensor_at<D>(now.P(), point);
  seen.stress = stress_measures<D>(now.body.regions[region_of<D>(now.body, point)], seen.H, seen.P,
                                   present(now.state, point));
  return seen;
}

template const Quantity<1>* find_quantity<1>(std::string_view);
template const Quantity<2>* find_quantity<2>(std::string_view);
template const Quantity<1>& quantity_named<1>(std::string_view);
template const Quantity<2>& quantity_named<2>(std::string_view);
template std::vector<std::string> component_suffixes<1>(const Quantity<1>&);
template std::vector<std::string> component_suffixes<2>(const Quantity<2>&);

template Observed<1> observed_particle<1>(const Instant<1>&, Index);
template Observed<2> observed_particle<2>(const Instant<2>&, Index);
template Observed<1> observed_point<1>(const Instant<1>&, Index);
template Observed<2> observed_point<2>(const Instant<2>&, Index);

}  // namespace tlsph

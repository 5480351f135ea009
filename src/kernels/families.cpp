#include "tlsph/kernels/families.hpp"

#include <type_traits>

namespace tlsph {

namespace {

/// Calls visitor with one instance of each family of the variant.
template <class Visitor, class... Families>
void for_each_family(std::type_identity<std::variant<Families...>>, Visitor visitor) {
  static_assert((KernelFamily<Families> && ...));
  (visitor(Families{}), ...);
}

constexpr std::type_identity<AnyKernel> all_families;

}  // namespace

std::optional<AnyKernel> kernel_by_name(std::string_view name) {
  std::optional<AnyKernel> found;
  for_each_family(all_families, [&](auto family) {
    if (family.name == name) found = family;
  });
  return found;
}

std::vector<std::string_view> kernel_names() {
  std::vector<std::string_view> names;
  for_each_family(all_families, [&](auto family) { names.push_back(family.name); });
  return names;
}

}  // namespace tlsph

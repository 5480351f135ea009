#include "tlsph/kernels/families.hpp"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace tlsph {
namespace {

template <KernelFamily... Families>
std::vector<AnyKernel> one_of_each(std::type_identity<std::variant<Families...>>) {
  return {Families{}...};
}

std::string_view name_of(const AnyKernel& kernel) {
  return std::visit([](const auto& family) { return family.name; }, kernel);
}

}  // namespace

std::optional<AnyKernel> kernel_by_name(std::string_view name) {
  for (const AnyKernel& kernel : one_of_each(std::type_identity<AnyKernel>()))
    if (name_of(kernel) == name) return kernel;
  return {};
}

std::vector<std::string_view> kernel_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(one_of_each(std::type_identity<AnyKernel>()), std::back_inserter(names),
                         name_of);
  return names;
}

}  // namespace tlsph

#include "tlsph/materials/any_law.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tlsph/core/error.hpp"

namespace tlsph {

namespace {

template <int D, class... Text>
AnyLaw<D> make_listed(laws::List<Text...>, std::size_t index, std::span<const double> values) {
  using Make = AnyLaw<D> (*)(std::span<const double>);
  constexpr Make make[] = {
      [](std::span<const double> of) -> AnyLaw<D> { return Law<Text>(of); }...};
  return make[index](values);
}

void check_constants(LawName name, std::span<const double> values) {
  const std::span<const LawConstant> constants = constants_of(name);
  if (values.size() != constants.size())
    throw InputError(
        fmt::format("material.law: {} constants, not {}", constants.size(), values.size()));
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!constants[k].range.contains(values[k]))
      throw InputError(fmt::format("{}: must be {}, not {}", constants[k].name,
                                   constants[k].range.requirement(), values[k]));
}

}  // namespace

template <int D>
AnyLaw<D> make_law(LawName name, Assumption assumption, std::span<const double> constants) {
  check_constants(name, constants);
  const auto index = 2 * static_cast<std::size_t>(name) + static_cast<std::size_t>(assumption);
  return make_listed<D>(laws::Listed<D>(), index, constants);
}

std::vector<LawConstant> all_law_constants() {
  std::vector<LawConstant> all;
  for (const std::span<const LawConstant> each : laws::constants(laws::Listed<2>()))
    for (const LawConstant& constant : each)
      if (std::ranges::find(all, constant.name, &LawConstant::name) == all.end())
        all.push_back(constant);
  return all;
}

Moduli moduli_at_rest(LawName name, std::span<const double> constants) {
  return std::visit([](const auto& law) { return moduli_at_rest(law); },
                    make_law<3>(name, Assumption::strain, constants));
}

template <int D>
std::string range(const AnyLaw<D>& law) {
  return std::visit(
      []<class Held>(const Held& held) -> std::string {
        std::string text = "det F > 0";
        if constexpr (requires { Held::range; }) text = Held::range;
        if constexpr (requires { held.largest_uniaxial_stretch(); }) {
          const double stretch = held.largest_uniaxial_stretch();
          if (stretch > 1) text += fmt::format(" (uniaxial stretch below {:.3f})", stretch);
          text += "; \"neo-hookean\" goes further";
        }
        return text;
      },
      law);
}

#define TLSPH_INSTANTIATE(D)                                                    \
  template AnyLaw<D> make_law<D>(LawName, Assumption, std::span<const double>); \
  template std::string range<D>(const AnyLaw<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
TLSPH_INSTANTIATE(3)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph

#pragma once
/// \file
/// The list of the laws. A new law is its text in a header of its own, and here its enumerator and
/// two entries; names, keys, the maker and the inner loops of a sweep follow.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "tlsph/materials/neo_hookean.hpp"
#include "tlsph/materials/st_venant_kirchhoff.hpp"

namespace tlsph {

enum class LawName { linear_elastic, st_venant_kirchhoff, neo_hookean };

namespace laws {

template <class... Text>
struct List {
  static constexpr std::size_t size = sizeof...(Text);
};

/// In the order of LawName, in strain and in stress each.
template <int D>
using Listed =
    List<LinearElastic<D, Assumption::strain>, LinearElastic<D, Assumption::stress>,
         StVenantKirchhoff<D, Assumption::strain>, StVenantKirchhoff<D, Assumption::stress>,
         NeoHookean<D, Assumption::strain>, NeoHookean<D, Assumption::stress>>;

template <class... Text>
constexpr auto names(List<Text...>) {
  constexpr std::string_view each[] = {Text::name...};
  std::array<std::string_view, sizeof...(Text) / 2> result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = each[2 * k];
  return result;
}

template <class... Text>
constexpr auto constants(List<Text...>) {
  constexpr std::span<const LawConstant> each[] = {Text::keys...};
  std::array<std::span<const LawConstant>, sizeof...(Text) / 2> result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = each[2 * k];
  return result;
}

}  // namespace laws

/// By LawName.
inline constexpr auto law_names = laws::names(laws::Listed<2>());
static_assert(law_names[static_cast<std::size_t>(LawName::linear_elastic)] == "linear-elastic");
static_assert(law_names[static_cast<std::size_t>(LawName::neo_hookean)] == "neo-hookean");

/// In the order in which a law takes their values.
[[nodiscard]] constexpr std::span<const LawConstant> constants_of(LawName name) {
  return laws::constants(laws::Listed<2>())[static_cast<std::size_t>(name)];
}

}  // namespace tlsph

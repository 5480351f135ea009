#pragma once
/// \file
/// The constants of the laws as keys of [material]. Not for other rooms.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schema.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {

/// The laws that have the constant.
inline std::vector<std::string_view> laws_with(std::string_view constant) {
  std::vector<std::string_view> names;
  for (const auto& [name, law] : Names<LawName>::list)
    if (std::ranges::count(constants_of(law), constant, &LawConstant::name) > 0)
      names.push_back(name);
  return names;
}

/// The constants of the laws, before the density of a material.
inline std::vector<Key> with_law_constants(std::vector<Key> keys) {
  for (const std::string group : {"material", "region"})
    for (const LawConstant& constant : all_law_constants()) {
      const auto laws = laws_with(constant.name);
      std::string standard;
      if (group == "region")
        standard = "(of [material])";
      else if (laws.size() < law_names.size())
        standard = fmt::format("(required by {})", fmt::join(laws, ", "));
      const auto density = std::ranges::find_if(
          keys, [&](const Key& key) { return key.group == group && key.name == "density"; });
      keys.insert(density,
                  Key{group, std::string(constant.name), number, "", std::string(constant.unit),
                      standard, constant.range, std::string(constant.meaning)});
    }
  return keys;
}

}  // namespace tlsph

#pragma once
/// \file
/// What a field is: where it lives and how many components it has.

#include <cstddef>
#include <string>
#include <vector>

namespace tlsph {

/// Where a field lives.
enum class Site { particles, points };
/// Components of a field in d dimensions: d^rank.
enum class Rank { scalar = 0, vector = 1, tensor = 2 };

[[nodiscard]] constexpr std::size_t component_count(Rank rank, std::size_t dimension) {
  return rank == Rank::scalar ? 1 : rank == Rank::vector ? dimension : dimension * dimension;
}

/// Names of the components in their order: nothing for a scalar, "x y" or "xx xy yx yy".
[[nodiscard]] inline std::vector<std::string> component_names(Rank rank, std::size_t dimension) {
  std::vector<std::string> names{""};
  for (int order = 0; order < static_cast<int>(rank); ++order) {
    std::vector<std::string> longer;
    for (const std::string& name : names)
      for (std::size_t a = 0; a < dimension; ++a) longer.push_back(name + "xyz"[a]);
    names = std::move(longer);
  }
  return names;
}

}  // namespace tlsph

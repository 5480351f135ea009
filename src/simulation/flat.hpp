#pragma once
/// \file
/// Fields and patches as the files of `io` take them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// The numbers of a matrix in a row.
[[nodiscard]] std::span<const double> flat(const auto& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

/// Bit k of a node: it belongs to patch k. The bits of an int64 but the last two.
struct PatchTags {
  std::vector<std::int64_t> bits;
  std::vector<std::string> names;
};

template <int D>
[[nodiscard]] PatchTags patch_tags(const Particles<D>& particles) {
  PatchTags tags{std::vector<std::int64_t>(static_cast<std::size_t>(particles.size()), 0), {}};
  for (std::size_t bit = 0; bit < particles.patches.size() && bit < 62; ++bit) {
    tags.names.push_back(particles.patches[bit].name);
    for (const int node : particles.patches[bit].nodes)
      tags.bits[static_cast<std::size_t>(node)] |= std::int64_t{1} << bit;
  }
  return tags;
}

}  // namespace tlsph

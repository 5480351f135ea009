#pragma once
/// \file
/// A field as its numbers in a row.

#include <cstddef>
#include <span>

namespace tlsph {

[[nodiscard]] std::span<const double> flat(const auto& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

}  // namespace tlsph

#pragma once
/// \file
/// What fails, why, and what cures it, in words.

#include <string>
#include <string_view>

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

struct Words {
  std::string what, why, cure;
};

/// The way in which a row that is not stable fails; rows of one group are told of together.
[[nodiscard]] std::string group_of(const AtlasRow& row);
[[nodiscard]] Words words_of(std::string_view group);

}  // namespace tlsph

#pragma once
/// \file
/// The constants of a law. Each is a key of a scene's [material].

#include <array>
#include <string_view>

#include "tlsph/core/range.hpp"

namespace tlsph {

struct LawConstant {
  std::string_view name, unit;
  Range range;
  std::string_view meaning;
};

/// Of the laws that are isotropic at small strains with two constants.
inline constexpr std::array<LawConstant, 2> isotropic_constants = {
    {{"young", "Pa", above(0.0), "Young's modulus E"},
     {"poisson", "", between(-1.0, 0.5), "Poisson's ratio"}}};

}  // namespace tlsph

#pragma once
/// \file
/// How tables call the verdicts.

#include <string_view>

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

[[nodiscard]] constexpr std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::refused:
      return "refused";
    case Verdict::material:
      return "material";
    case Verdict::negative:
      return "negative";
    case Verdict::growing:
      return "growing";
    case Verdict::soft:
      return "soft";
    case Verdict::stable:
      break;
  }
  return "stable";
}

}  // namespace tlsph

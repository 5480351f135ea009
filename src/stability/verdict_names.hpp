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

/// The same in one letter.
[[nodiscard]] constexpr char verdict_letter(Verdict verdict) {
  switch (verdict) {
    case Verdict::refused:
      return 'R';
    case Verdict::material:
      return 'm';
    case Verdict::negative:
      return 'N';
    case Verdict::growing:
      return 'G';
    case Verdict::soft:
      return 's';
    case Verdict::stable:
      break;
  }
  return '.';
}

}  // namespace tlsph

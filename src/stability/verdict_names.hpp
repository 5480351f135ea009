#pragma once
/// \file
/// How tables call the verdicts.

#include <algorithm>
#include <array>
#include <string_view>

#include "tlsph/stability/atlas.hpp"

namespace tlsph {

struct VerdictName {
  Verdict verdict;
  std::string_view name;
  char letter;
};
inline constexpr std::array verdict_names = {VerdictName{Verdict::refused, "refused", 'R'},
                                             VerdictName{Verdict::material, "material", 'm'},
                                             VerdictName{Verdict::negative, "negative", 'N'},
                                             VerdictName{Verdict::growing, "growing", 'G'},
                                             VerdictName{Verdict::soft, "soft", 's'},
                                             VerdictName{Verdict::stable, "stable", '.'}};

[[nodiscard]] constexpr const VerdictName& name_of(Verdict verdict) {
  return *std::ranges::find(verdict_names, verdict, &VerdictName::verdict);
}

}  // namespace tlsph

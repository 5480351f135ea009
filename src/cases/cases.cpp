#include "tlsph/cases/cases.hpp"

#include <array>

#include "list.hpp"

namespace tlsph {

std::span<const Case> all_cases() {
#define TLSPH_ENTRY(name, title, seconds, quick) Case{#name, title, seconds, quick, name},
  static constexpr std::array list = {TLSPH_CASES(TLSPH_ENTRY)};
#undef TLSPH_ENTRY
  return list;
}

}  // namespace tlsph

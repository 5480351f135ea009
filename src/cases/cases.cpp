#include "tlsph/cases/cases.hpp"

#include <array>

#include "list.hpp"

namespace tlsph {

std::span<const Case> all_cases() {
  // name (the folder), title, seconds on one core, quick, function
  static constexpr std::array list = {
      Case{"three_materials", "wave speeds of three materials", 1.0, true, three_materials},
  };
  return list;
}

}  // namespace tlsph

#include "tlsph/cases/cases.hpp"

#include <array>

#include "list.hpp"

namespace tlsph {

std::span<const Case> all_cases() {
  // name (the folder), title, seconds on one core, quick, function
  static constexpr std::array list = {
      Case{"three_materials", "wave speeds of three materials", 1.0, true, three_materials},
      Case{"dispersion", "waves on a lattice and modes without energy", 1.0, true, dispersion},
  };
  return list;
}

}  // namespace tlsph

#include "tlsph/materials/lame.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {

Lame lame(double young, double poisson) {
  if (!(young > 0) || !std::isfinite(young))
    throw InputError(fmt::format("Young's modulus is {} Pa; it must be positive", young));
  if (!(poisson > -1 && poisson < 0.5))
    throw InputError(
        fmt::format("Poisson's ratio is {}; it must lie between -1 and 0.5 (0.5, incompressible, "
                    "has no finite wave speed)",
                    poisson));
  return {young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

}  // namespace tlsph

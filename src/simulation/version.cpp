#include "tlsph/simulation/version.hpp"

namespace tlsph {

std::string version() {
  return TLSPH_VERSION;
}

}  // namespace tlsph

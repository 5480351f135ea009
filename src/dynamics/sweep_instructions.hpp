#pragma once
/// \file
/// Which of the compiled inner loops an option asks for. Not for other rooms.

#include "sweep_kernels.hpp"
#include "tlsph/dynamics/sweep.hpp"

namespace tlsph::sweep {

[[nodiscard]] Level level_of(Instructions instructions);

}  // namespace tlsph::sweep

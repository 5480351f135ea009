#pragma once
/// \file
/// Fast compression: an edge of the body moves in at a share of the speed of sound until the
/// stretch is 0.2, and the critical step falls to a fraction. Does the step follow, how closely,
/// and at what cost?

#include "specimen.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

enum class Motion {
  pressed,  ///< the whole body is in homogeneous motion: no wave is sent
  struck,   ///< the body is at rest when the edge sets out: a shock runs through it
};

enum class Follow {
  never,     ///< the step of the undeformed body all the way
  follower,  ///< dynamics/step_follower.hpp, as runs do
};

/// `finer`: the body divided so many times finer, not compared with the true limit on the way: what
/// following costs a body that is not small.
[[nodiscard]] CrushRow crush_row(const Subject& subject, const Method& method, Motion motion,
                                 double speed, double safety, Follow follow, int finer = 1);

/// Methods of the dimension that are crushed.
[[nodiscard]] std::vector<Method> crushed_methods(int dimension);

}  // namespace tlsph

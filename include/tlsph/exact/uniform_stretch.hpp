#pragma once
/// \file
/// A body drawn out so slowly that it stays homogeneous.

#include "tlsph/curves/curve.hpp"
#include "tlsph/exact/exact.hpp"
#include "tlsph/materials/any_law.hpp"

namespace tlsph {

/// The body between x = fixed_end and x = fixed_end + length, stretched along x by moving the far
/// end.
struct UniformStretch {
  double fixed_end = 0.0;  ///< [m]
  double length = 0.0;     ///< [m], reference; negative if the fixed end is the upper one
  Curve elongation;        ///< displacement of the far end along x [m]
};

/// u_x = elongation(t) (X − fixed_end)/length and no lateral motion: H_xx = elongation/length, P
/// from the law. Quasi-static: exact where the load is slow against the wave transit. Throws
/// InputError for length = 0. D is 1 or 2.
template <int D>
[[nodiscard]] ExactSolution<D> uniform_stretch(const UniformStretch& stretch, const AnyLaw<D>& law);

}  // namespace tlsph

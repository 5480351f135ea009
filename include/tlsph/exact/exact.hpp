#pragma once
/// \file
/// Exact solutions a scene can name, as plain functions of reference position and time. Linear
/// elastic unless said otherwise.

#include <functional>

#include "tlsph/core/types.hpp"

namespace tlsph {

template <int D>
struct ExactSolution {
  std::function<Vector<D>(const Vector<D>& X, double t)> displacement;  ///< u [m]
  std::function<Vector<D>(const Vector<D>& X, double t)> velocity;      ///< ∂u/∂t [m/s]
  std::function<Tensor<D>(const Vector<D>& X, double t)> stress;  ///< first Piola–Kirchhoff [Pa]
};

}  // namespace tlsph

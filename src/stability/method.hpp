#pragma once
/// \file
/// What the atlas varies: methods, layouts, Poisson ratios, stretches, bodies.

#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Operators of a scene.
struct Method {
  std::string name;
  Formulation formulation = Formulation::stress_point;
  KernelScene kernel;
  StabiliserScene stabiliser;
  Defaulted<GhostClosure> ghosts = GhostClosure::consistent;
  Defaulted<std::optional<ConsistencyScene>> consistency;
  /// All states, or a few: kernels and supports that differ in degree only, formulations whose
  /// spectra are dear.
  enum class Cover { all, few, reference } cover = Cover::all;
  bool lattice = false;       ///< cannot have irregular particles
  bool cell_centred = false;  ///< may have no particle on the boundary

  /// Gives the scene these operators; what a method leaves open stays.
  void apply_to(Scene& scene) const;
};

[[nodiscard]] std::vector<Method> atlas_methods(int dimension);

/// Where a method is looked at.
struct StateKey {
  Method method;
  int strip = 0;  ///< 0: the body of the scene; n: a strip n particles thick
  double jitter = 0.0;
  double poisson = 0.3;
  double stretch = 1.0;
  [[nodiscard]] std::string name() const;
};

[[nodiscard]] std::vector<StateKey> atlas_states(int dimension, double poisson);

}  // namespace tlsph

#pragma once
/// \file
/// Every way to model a scene that a chart considers, but for the spacing.

#include <optional>
#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

struct ChartFamily {
  std::string label;                   ///< "variational 2.5 order 2 pair viscosity"
  std::vector<std::string> overrides;  ///< what sets it, key=value
  std::string formulation, kernel, stabiliser;
  std::optional<double> support;
  int order = 1;
  int distance = 0;  ///< choices that are not the formulation's default
  // Variants of a family (chart_variants.hpp).
  bool linear = false;               ///< a linear law in the place of the scene's
  std::optional<double> step_share;  ///< of the critical step; empty: the scene gives the step
};

/// Formulation × kernel × support × order × stabiliser, those nearest to the defaults first. Some
/// may not go with the scene; that is found when they are read or built.
[[nodiscard]] std::vector<ChartFamily> chart_families(int dimension,
                                                      const std::vector<std::string>& wanted);

}  // namespace tlsph

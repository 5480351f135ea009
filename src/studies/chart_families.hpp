#pragma once
/// \file
/// The ways to model a scene that a chart considers, but for the spacing: families, and of the best
/// of them variants of time step and law. Errors of central differences in time and of two-node
/// differences in space have opposite signs and nearly cancel next to the critical step; operators
/// of high order leave the error of time alone, which a shorter step cures.

#include <optional>
#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"
#include "tlsph/studies/chart.hpp"

namespace tlsph {

struct ChartFamily : ChartModel {
  int distance = 0;     ///< choices that are not the formulation's default
  bool linear = false;  ///< a linear law in the place of the scene's
};

/// Formulation × kernel × support × order × stabiliser, those nearest to the defaults first. Some
/// may not go with the scene; that is found when they are read or built.
[[nodiscard]] std::vector<ChartFamily> chart_families(int dimension,
                                                      const std::vector<std::string>& wanted);

/// Near enough to the critical step to cancel, and safe: the computed limit of adjoint formulations
/// is the true one within 0.2 %.
inline constexpr double largest_share = 0.99;

struct ChartVariation {
  double own_share = 0.0;           ///< the scene's
  std::vector<double> shares;       ///< large to small, the scene's among them; empty: time.step
  std::vector<std::string> linear;  ///< overrides of a linear law; empty: no choice
  std::string law;                  ///< of the scene's materials, joined by "+"

  /// What law and share of a family need beyond the scene, key=value.
  [[nodiscard]] std::vector<std::string> overrides(const ChartFamily& family) const;
  [[nodiscard]] std::string law_of(const ChartFamily& family) const;
};

[[nodiscard]] ChartVariation chart_variation(const Scene& scene);

/// " linear step 0.99": what a label says of law and step; nothing of the scene's own.
[[nodiscard]] std::string variant_label(bool linear, std::optional<double> share, double own_share);

/// The family with the next larger and the next smaller share, and with the other law. Formulations
/// whose D is not the adjoint of G are not given a larger share than the scene's: their limit is no
/// promise.
[[nodiscard]] std::vector<ChartFamily> neighbours(const ChartFamily& family,
                                                  const ChartVariation& variation);

}  // namespace tlsph

#pragma once
/// \file
/// What decides speed against accuracy beside the family and the spacing: the time step as a share
/// of the critical one, and the law. Errors of central differences in time and of two-node
/// differences in space have opposite signs and nearly cancel next to the critical step; operators
/// of high order leave the error of time alone, which a shorter step cures.

#include <string>
#include <vector>

#include "chart_families.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Near enough to the critical step to cancel, and safe: the computed limit of adjoint formulations
/// is the true one within 0.2 %.
inline constexpr double largest_share = 0.99;

struct ChartVariation {
  double own_share = 0.0;           ///< the scene's
  std::vector<double> shares;       ///< large to small, the scene's among them; empty: time.step
  std::vector<std::string> linear;  ///< overrides of a linear law; empty: no choice
  std::string law;                  ///< of the scene's materials, joined by "+"

  /// Of a family, key=value, what its law and its share need beyond the scene.
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

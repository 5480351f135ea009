#pragma once
/// \file
/// A run of a bar with d'Alembert's solution beside it.

#include <span>
#include <string>

#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// A scene with `reference.exact = "bar-wave"` and what its probes should have recorded.
struct BarWaveRun {
  CaseScene scene;

  /// Runs the scene; the arguments are those of CaseRun::scene.
  BarWaveRun(CaseRun& run, const std::string& label, const std::string& file,
             const std::vector<std::string>& overrides);

  [[nodiscard]] std::span<const double> time() const { return scene.probes.computed.time; }
  /// P_xx at a probe [Pa], computed and exact.
  [[nodiscard]] std::span<const double> stress(const std::string& probe) const;
  [[nodiscard]] std::span<const double> exact_stress(const std::string& probe) const;
  /// Relative L2 error in time of the stress at a probe.
  [[nodiscard]] double error(const std::string& probe) const;
};

}  // namespace tlsph

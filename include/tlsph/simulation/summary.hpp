#pragma once
/// \file
/// The numbers a run ends with (summary.json) and a plan promises.

#include <optional>
#include <string>
#include <vector>

#include "tlsph/core/types.hpp"
#include "tlsph/dynamics/hyperbolicity.hpp"
#include "tlsph/operators/consistency.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph {

/// Relative L2 errors against the scene's exact solution at the end, √(Σ V|a−b|²/Σ V|b|²).
struct FieldErrors {
  double displacement = 0.0;
  double velocity = 0.0;
  double stress = 0.0;  ///< first Piola–Kirchhoff, at the material points
};

struct EnergyLedger {
  double kinetic = 0.0;         ///< as Balance [J per unit thickness]
  double elastic = 0.0;         ///< Σ V Ψ plus the stabiliser's ½ uᵀ S u
  double external_work = 0.0;   ///< loads and supports
  double dissipated = 0.0;      ///< by the viscous matrix C and by laws
  double drift_relative = 0.0;  ///< max |E − E₀ − W| / max E
};

/// A load and where it acts.
struct LoadedPatch {
  std::string where;
  double length = 0.0;            ///< of the loaded boundary [m]; in 1D the number of its ends
  std::vector<double> resultant;  ///< at the amplitude of the load, by component [N]

  /// "load on …", for people.
  [[nodiscard]] std::string text() const;
};

struct Summary {
  std::string scene, title, version;
  int dimension = 0;
  std::string formulation, kernel;
  std::optional<double> support;  ///< in spacings; empty: the nodes of a cell
  Index particles = 0, ghosts = 0, points = 0, nonzeros = 0;
  double neighbours_mean = 0.0, spacing = 0.0;
  double dt = 0.0, dt_critical = 0.0, dt_critical_scaled = 0.0;  ///< scaled: c_p Δt/Δ
  std::optional<double>
      growth_rate;  ///< largest Re(s) of e^{st}, where D is not the adjoint of G [1/s]
  long steps = 0;
  double end_time = 0.0;
  int threads = 1;
  double wall_setup = 0.0, wall_stepping = 0.0, wall_output = 0.0;  ///< [s]
  double ns_per_particle_step = 0.0;
  std::optional<StorageReport> storage;  ///< of the operators as a sweep reads them
  double peak_memory_bytes = 0.0;
  EnergyLedger energy;
  double linear_momentum_drift = 0.0, angular_momentum_drift = 0.0;
  std::optional<FieldErrors> errors;
  /// What is left of the constraints of a corrected gradient, lengths in spacings.
  std::optional<ConsistencyResiduals> consistency;
  std::optional<HyperbolicityLoss> hyperbolicity_lost;  ///< by the material; never by linear laws
  std::vector<LoadedPatch> loads;
  std::vector<std::string> warnings;  ///< what the user should know before trusting the result
  std::string boundary_solver;        ///< what factorised the modified SPH matrix, empty otherwise
  std::string failure;                ///< empty when all went well
  bool interrupted = false;           ///< stopped by a signal, checkpoint written

  /// The text of summary.json.
  [[nodiscard]] std::string json() const;
};

struct Plan {
  std::string text;  ///< what `tlsph plan` prints
};

}  // namespace tlsph

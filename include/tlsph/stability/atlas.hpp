#pragma once
/// \file
/// The atlas of stability: where methods fail on a body of a given shape and material, why, and
/// what cures it. A state is a method (formulation, kernel, support, stabiliser) on a layout of
/// particles at a Poisson ratio and a stretch; each is judged by the whole spectrum of its
/// operators, and the judgement is confirmed by runs.
///
/// Page of the room, src/stability:
///   method, sample         what is varied, and the body of one state, its spectrum and its runs
///   studies                the tables of the atlas: states, waves, contrast, compression
///   failures               failures as text, each with a run that shows it and its cure

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/types.hpp"

namespace tlsph {

/// What became of a state. The first that applies, in this order.
enum class Verdict {
  refused,   ///< the operators could not be built: too few neighbours, or what a scene may not ask
  material,  ///< the acoustic tensor of the law is not positive: no method carries waves there
  negative,  ///< ω² < 0 though the material carries waves: the operators lose the stability it has
  growing,   ///< D is no adjoint of G, and motions grow at any step
  zero_energy,  ///< modes without energy beside the rigid motions
  stable,
};

/// A run from the state, its particles displaced at random by 1e-10 Δ, the forces of the state
/// taken off so that it is one of equilibrium.
struct PerturbedRun {
  std::string label;            ///< "0.95", "1.02", or "h/c" for the step of that rule
  double ratio = not_known;     ///< Δt over the computed critical step
  double expected = not_known;  ///< growth a step, ln |z| of the fastest mode of the spectrum
  double seen = not_known;      ///< growth a step over the last decades of the run
  double amplitude = not_known;  ///< largest √(2T) over √(2E₀), E₀ the energy of the perturbation
  double energy_drift = not_known;  ///< of a run with velocities of 1e-3 c, over its first energy
  long steps = 0;
  long lost_at = -1;  ///< step of the first det F ≤ 0, −1 if there was none
  [[nodiscard]] bool bounded() const { return lost_at < 0 && amplitude < 10.0; }
};

struct AtlasRow {
  std::string name;  ///< method, layout, Poisson ratio, stretch
  std::string method, formulation, kernel, body;
  double support = not_known;  ///< [Δ], not a number for the nodes of a cell
  double jitter = 0.0;         ///< [Δ]
  double poisson = 0.0;
  double stretch = 1.0;  ///< of the first direction, the other one held
  Index particles = 0;
  std::string refusal;
  double acoustic = not_known;   ///< smallest eigenvalue of the acoustic tensor over λ + 2μ
  double imbalance = not_known;  ///< largest force of the uniform state over |P| Δ^(d−1)
  double drift = not_known;      ///< largest speed over c_p of the uniform state left to itself
  double bound = not_known;      ///< the critical step a run computes, c_p Δt/Δ
  double limit = not_known;      ///< the same from the dense spectrum
  Index zero_energy_modes = -1;  ///< modes below half the first true ω², rigid ones not counted
  double excursion =
      not_known;              ///< of a free run in its lowest mode, over that of the first true one
  Index negative = -1;        ///< ω² < 0 with the boundary held
  double growth = not_known;  ///< largest Re(s) of a free motion [c_p/Δ]
  Verdict verdict = Verdict::stable;
  std::vector<PerturbedRun> runs;

  /// The run of that label, nullptr if there is none.
  [[nodiscard]] const PerturbedRun* run(std::string_view label) const;
};

/// Waves on the undeformed lattice.
struct WaveRow {
  std::string method;
  double poisson = 0.0;
  int zero_energy = 0;  ///< waves at the corners of the Brillouin zone
  /// Largest |c/c₀ − 1| of transverse and longitudinal waves of 8 spacings, and its spread over the
  /// directions.
  double transverse = not_known, longitudinal = not_known;
  double anisotropy = not_known;
  double slowest = not_known;  ///< smallest c/c₀ of the zone [0, π]², π/Δ in every direction
  std::vector<std::vector<double>> map;  ///< rows: kΔ (d), c/c₀ (d)
};

/// The counter-example at one stress.
struct ContrastRow {
  int dimension = 1;
  double stress = 0.0;           ///< σ₀/(ρc²), tension positive
  double expected = not_known;   ///< growth rate of the linearised sums [c/Δ]
  double seen = not_known;       ///< of the run; zero where it stays bounded
  double amplitude = not_known;  ///< largest kinetic energy over the first
};

/// Fast compression to a stretch of 0.2, with one step for all or a step that follows the body.
struct CompressionRow {
  std::string method, motion, step;
  Index particles = 0;
  double speed = not_known;  ///< of the moving edge, over c_p
  double safety = not_known;
  long steps = 0, looks = 0, bounds = 0, estimates = 0;
  double share = not_known;     ///< of the stepping time spent on following
  double closest = not_known;   ///< largest Δt over the true critical step on the way
  double smallest = not_known;  ///< smallest det F that was reached
  std::string failure;
};

/// One failure: where, why, what cures it; with the rows that show both.
struct Failure {
  std::string where, what, why, cure;
  std::string run, cured_run;  ///< names of rows and what their runs showed
  Index states = 0;
};

/// Whether the computed critical step can be trusted: over all states whose material carries waves.
struct Safety {
  double smallest_share = std::numeric_limits<double>::infinity();  ///< of the true limit
  double largest_share = 0.0;
  Index stable_states = 0;  ///< that have no growth below the limit
  Index lost_runs = 0;      ///< of these, at 0.95 of the computed step
};

struct Atlas {
  std::string scene, version;
  int dimension = 2;
  std::vector<AtlasRow> rows;
  std::vector<WaveRow> waves;
  std::vector<ContrastRow> contrast;
  std::vector<CompressionRow> compression;
  std::vector<Failure> failures;
  bool interrupted = false;
  double seconds = 0.0;

  [[nodiscard]] Safety safety() const;
  /// What `tlsph stability` prints.
  [[nodiscard]] std::string text() const;
  /// Writes stability.csv (a line a run), waves.csv, stability.json.
  void write(const std::filesystem::path& directory) const;
};

struct AtlasRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, as for a run
  std::string only;                    ///< regular expression on the names of rows; empty: all
};

struct AtlasOptions {
  std::filesystem::path out;  ///< made once the request is sound; empty: none is made
  std::function<void(double share, const std::string& what)> progress;  ///< may be empty
  const std::atomic<bool>* stop_requested = nullptr;
};

/// Draws the atlas on the body and material of the scene. InputError for what is wrong with it, for
/// more than one material, points of a file, and a regular expression that is none or matches
/// nothing. OutputError, before anything is computed, where `out` cannot be made.
[[nodiscard]] Atlas draw_atlas(const AtlasRequest& request, const AtlasOptions& options);

}  // namespace tlsph

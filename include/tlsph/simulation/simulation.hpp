#pragma once
/// \file
/// A scene becomes a run: particles, operators, boundaries and steps, with its files. The dimension
/// is picked here, once; everything below is a template on it.

#include <atomic>
#include <filesystem>
#include <functional>

#include "tlsph/observe/history.hpp"
#include "tlsph/scene/scene.hpp"
#include "tlsph/simulation/summary.hpp"

namespace tlsph {

/// Where a run stands, for a progress display.
struct Progress {
  double time = 0.0;  ///< simulated [s]
  double end = 0.0;   ///< simulated [s]
  long step = 0;
  long steps = 0;  ///< estimate of the last step
};

struct RunOptions {
  std::filesystem::path out;  ///< directory of run.h5, probes.csv, …; empty: nothing is written
  int threads = 0;            ///< 0: all cores, one for small problems
  bool resume = false;        ///< go on from the checkpoint in `out`
  /// Where the rows of probes.csv and probes_exact.csv go too, those since `resume`; also of a run
  /// that ends by a NumericalError.
  ProbeHistories* histories = nullptr;
  std::function<void(const Progress&)> progress;  ///< called about ten times a second, may be empty
  const std::atomic<bool>* stop_requested =
      nullptr;  ///< set by a signal: finish the step, save, return
};

/// Runs the scene to its end. Throws InputError before anything is written, NumericalError with the
/// last good state on disk, OutputError.
Summary run(const Scene& scene, const RunOptions& options);

/// What would be modelled and what it costs; builds the operators of the scene but runs nothing.
/// Throws InputError, also when the estimated memory exceeds the machine's.
Plan plan(const Scene& scene);

/// Writes every operator of the scene as Matrix Market files, operators.h5 and report.json into
/// `out`.
void export_operators(const Scene& scene, const std::filesystem::path& out);

/// Relative default output directory: out/<stem of the scene file>.
std::filesystem::path default_output(const Scene& scene);

}  // namespace tlsph

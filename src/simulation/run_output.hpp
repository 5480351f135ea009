#pragma once
/// \file
/// The files of a run: run.h5, run.xdmf, probes.csv, probes_exact.csv, checkpoint. Not for other
/// rooms.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "tlsph/dynamics/ledger.hpp"
#include "tlsph/exact/exact.hpp"
#include "tlsph/io/checkpoint.hpp"
#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/run_file.hpp"
#include "tlsph/io/xdmf.hpp"
#include "tlsph/observe/probes.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Rows written so far, for a checkpoint.
struct OutputCounts {
  RunRows run;
  CsvRows probes, exact;
};

template <int D>
class RunOutput {
 public:
  /// New files in `directory`, or those of a run that goes on after `resumed`. InputError, with
  /// nothing changed, if those are not there or not as they were written.
  RunOutput(const std::filesystem::path& directory, const Scene& scene,
            const Discretisation<D>& discretisation, const Probes<D>& probes,
            const ExactSolution<D>& exact, const std::optional<OutputCounts>& resumed);

  void write_frame(const Discretisation<D>& discretisation, const State<D>& state, double dt);
  void write_series(double time, std::span<const double> values) {
    run_file_->write_series(time, values);
  }
  /// A row of every table of probes. Of a state that may turn out to be lost, as long as it is not
  /// `evaluated`, only once `keep_probes` says that a step went on from it.
  void write_probes(const Discretisation<D>& discretisation, const State<D>& state, double dt,
                    bool evaluated);
  void keep_probes();
  /// Whether a frame of this time or a later one is there, to within `tolerance` [s].
  [[nodiscard]] bool has_frame(double time, double tolerance) const {
    const std::vector<double>& times = run_file_->frame_times();
    return !times.empty() && times.back() > time - tolerance;
  }
  /// Everything written reaches the system.
  void flush();
  [[nodiscard]] OutputCounts counts() const;

 private:
  std::span<const double> field(const std::string& name, const Discretisation<D>& discretisation,
                                const State<D>& state, double dt);
  void write_exact(double time);

  std::filesystem::path directory_;
  RunLayout layout_;
  DirectoryLock lock_;
  std::optional<RunFile> run_file_;
  std::size_t views_ = 0;  // frames that the file of views shows
  const Probes<D>* probes_;
  std::optional<CsvWriter> probe_file_, exact_file_;
  std::vector<double> probe_row_, exact_row_;
  bool row_waits_ = false;
  const ExactSolution<D>* exact_;
  std::vector<ProbeScene> requests_;
  std::map<std::string, std::vector<double>> scratch_;
};

/// Series columns of run.h5, in the order in which the run hands them over.
template <int D>
[[nodiscard]] std::vector<SeriesQuantity> series_layout();

}  // namespace tlsph
